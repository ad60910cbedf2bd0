#include "app/desktop/tracer_comparison.hpp"

#include "engine/render/render.hpp"
#include "tests/support/picture_of.hpp"
#include "ui/window/offscreen_window.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <thread>

// The picture of another tracer beside the window's.

namespace zeroset::test::tracer_comparison_test {
namespace {

class Comparison : public testing::Test {
protected:
    void SetUp() override {
        auto made = ui::make_offscreen_window({.width = 200, .height = 200, .scale = 1.0F});
        if (!made) GTEST_SKIP() << made.error();
        window_ = std::move(*made);
        comparison_ = std::make_unique<TracerComparison>([] {});
    }
    void TearDown() override { comparison_.reset(); }

    /// Shows a text as the window's tracer draws it.
    void show(const std::string& text, const std::string& tracer) {
        request_ = picture_of(text);
        request_.size_px = {96, 96};
        request_.settings.tracer = tracer;
        request_.settings.costs = state_.edited.inspection.costs;
        const RenderRequest request = render_request(request_);
        auto frame = std::make_shared<Framebuffer>(request.width, request.height);
        render_frame(request.scene, request.camera, request.settings, *frame);
        state_.edited.inspection.tracer = tracer;
        state_.shown.picture.frame = frame;
        state_.shown.picture.camera = request.camera;
    }
    /// The other tracer's complete picture.
    const ui::OtherPicture& wait() {
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        do {
            comparison_->follow(state_, &request_);
            comparison_->show(state_);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        } while (!state_.shown.other.complete && std::chrono::steady_clock::now() < until);
        comparison_->show(state_);
        return state_.shown.other;
    }

    std::unique_ptr<ui::OffscreenWindow> window_;  // outlives the texture
    std::unique_ptr<TracerComparison> comparison_;
    PictureRequest request_;
    ui::UiState state_;
};

TEST_F(Comparison, DrawsTheSamePictureByAnotherTracer) {
    show("x^2 + y^2 + z^2 = 1", "beams");
    state_.edited.inspection.other = "mitchell";
    const ui::OtherPicture& other = wait();
    ASSERT_TRUE(other.complete);
    EXPECT_EQ(other.tracer, "mitchell");
    EXPECT_EQ(other.camera, state_.shown.picture.camera);
    EXPECT_NE(other.texture, 0U);
    EXPECT_FALSE(other.wrong) << "nobody asked for the difference";
    std::size_t hits = 0;
    for (std::size_t i = 0; i < other.frame->surface.size(); ++i) {
        EXPECT_EQ(other.frame->surface[i], state_.shown.picture.frame->surface[i]);
        hits += other.frame->surface[i] != no_surface ? 1U : 0U;
    }
    EXPECT_GT(hits, 500U);
}

TEST_F(Comparison, ToldByTheTracerThatProves) {
    // Two sheets, nearer to each other than the steps of the samples.
    show("(z - 0.1)^2 = 1e-7", "point-sampling");
    state_.edited.inspection.other = "beams";
    state_.edited.inspection.difference = true;
    const ui::OtherPicture& other = wait();
    ASSERT_TRUE(other.wrong);
    EXPECT_EQ(other.reference, ui::Reference::Other);
    EXPECT_GT(other.wrong->missed, 100U);
    EXPECT_EQ(other.wrong->added, 0U);
}

TEST_F(Comparison, OfTracersThatBothProveShowsNothingWrong) {
    show("x^2 + y^2 + z^2 = 1", "k-bisection");
    state_.edited.inspection.other = "beams";
    state_.edited.inspection.difference = true;
    const ui::OtherPicture& other = wait();
    ASSERT_TRUE(other.wrong);
    EXPECT_EQ(other.reference, ui::Reference::First);
    EXPECT_EQ(other.wrong->missed, 0U);
    EXPECT_EQ(other.wrong->added, 0U);
    EXPECT_EQ(other.wrong->refuted, 0U);
}

TEST_F(Comparison, SaysWhereNobodyProves) {
    show("x^2 + y^2 + z^2 = 1", "point-sampling");
    state_.edited.inspection.other = "gargantini";
    state_.edited.inspection.difference = true;
    const ui::OtherPicture& other = wait();
    ASSERT_TRUE(other.wrong);
    EXPECT_EQ(other.reference, ui::Reference::None);
}

TEST_F(Comparison, KeepsCostsAndEndsWithTheWish) {
    state_.edited.inspection.costs = true;
    show("x^2 + y^2 + z^2 = 1", "beams");
    state_.edited.inspection.other = "newton";
    EXPECT_FALSE(wait().frame->cost.empty());
    state_.edited.inspection.other.reset();
    comparison_->follow(state_, &request_);
    comparison_->show(state_);
    EXPECT_EQ(state_.shown.other.frame, nullptr);
    EXPECT_EQ(state_.shown.other.texture, 0U);
}

}  // namespace
}  // namespace zeroset::test::tracer_comparison_test
