#include "pipeline/finish_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

// From a frame to the finished picture: what of the document is laid over it.

namespace zeroset::finish_picture_test {
namespace {

class FinishPicture : public testing::Test {
protected:
    FinishPicture() {
        auto frame = std::make_shared<Framebuffer>(400, 300);
        std::ranges::fill(frame->color, 0xFF203040U);
        std::ranges::fill(frame->depth, std::numeric_limits<float>::infinity());
        frame_ = frame;
    }
    [[nodiscard]] std::shared_ptr<const Framebuffer> finished(bool legend = true) const {
        const auto picture = finish_picture(frame_, {.document = document_,
                                                     .camera = camera_,
                                                     .coloring = coloring_,
                                                     .uniforms = uniforms_,
                                                     .legend = legend,
                                                     .points = points_});
        EXPECT_TRUE(picture) << picture.error();
        return picture.value_or(nullptr);
    }
    /// How many pixels differ from those of the frame.
    [[nodiscard]] std::ptrdiff_t changed(const Framebuffer& picture) const {
        std::ptrdiff_t count = 0;
        for (std::size_t i = 0; i < picture.color.size(); ++i)
            count += picture.color[i] != frame_->color[i] ? 1 : 0;
        return count;
    }

    std::vector<ShownPoint> points_;
    Document document_ = empty_document();
    Camera camera_ = default_camera(document_.clip, 4.0 / 3.0);
    Coloring coloring_;
    Uniforms uniforms_;
    std::shared_ptr<const Framebuffer> frame_;
};

TEST_F(FinishPicture, GivesTheFrameItselfWhereThereIsNothingToAdd) {
    EXPECT_EQ(finished(), frame_);
    coloring_.by = ColorBy::Height;
    coloring_.range = ValueRange{0, 1};
    EXPECT_EQ(finished(false), frame_);
}

TEST_F(FinishPicture, WritesTheNamesOfPointsBesideThem) {
    points_ = {{.row = 1, .name = "", .at = {0.5, 0.5, 0.5}, .radius = 0.05, .sliders = {}}};
    EXPECT_EQ(finished(), frame_) << "it has no name";
    points_[0].name = "P";
    const std::ptrdiff_t one = changed(*finished());
    EXPECT_GT(one, 50);
    points_[0].name = "Point";
    EXPECT_GT(changed(*finished()), one);
    points_[0].at = {100.0, 0.0, 0.0};
    EXPECT_EQ(changed(*finished()), 0) << "beyond the picture";
}

TEST_F(FinishPicture, AddsAxesMarkersAndTheLegend) {
    document_.axes = true;
    const std::ptrdiff_t axes = changed(*finished());
    EXPECT_GT(axes, 100);
    document_.markers = {{1, {0.5, 0.5, 0.5}}};
    const std::ptrdiff_t markers = changed(*finished());
    EXPECT_GT(markers, axes + 100);
    coloring_.by = ColorBy::Height;
    coloring_.range = ValueRange{0, 1};
    EXPECT_EQ(changed(*finished(false)), markers);
    EXPECT_GT(changed(*finished()), markers + 5000);
}

TEST_F(FinishPicture, ChangesNothingButColours) {
    document_.grid = true;
    document_.markers = {{1, {0, 0, 0}}};
    const auto picture = finished();
    EXPECT_EQ(picture->depth, frame_->depth);
    EXPECT_EQ(picture->certificate, frame_->certificate);
    EXPECT_EQ(picture->surface, frame_->surface);
}

}  // namespace
}  // namespace zeroset::finish_picture_test
