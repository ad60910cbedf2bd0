#include "engine/antialias/front_block.hpp"
#include "engine/antialias/square_depths.hpp"
#include "engine/antialias/square_field.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

// Fronts, in floats and in doubles: all rays of their pixels against closed forms.

namespace zeroset::test::fronts_test {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();
constexpr Camera aslant{
    .eye = {3, -4, 2.5}, .look_at = {0.1, 0, -0.1}, .up = {0, 0, 1}, .fov_rad = 0.6};

/// A tile of a picture of the sphere of a square of a radius, and a front for each pixel.
class FrontsOfASphere {
public:
    FrontsOfASphere(double square, const Camera& camera, Precision precision)
        : square_(square),
          scene_(scene_of("x^2 + y^2 + z^2 = " + std::to_string(square), Box::cube(1.5))),
          frame_(trace_frame(scene_, scene_.surfaces.front(), ViewFrame(camera),
                             {.width = 192, .height = 192}, {})),
          rays_(frame_, tile_) {
        frame_.precision = precision;
        for (std::size_t i = 0; i < std::size_t{tile_size} * tile_size; ++i)
            pixels_.push_back({.pixel = static_cast<std::uint16_t>(i),
                               .from = -100.0F,
                               .hit = std::numeric_limits<float>::infinity()});
        field_.emplace(rays_, 1);
        for (MixedPixel& pixel : pixels_)
            field_->add(pixel);
        field_->place_all();
    }

    void advance() {
        std::vector<std::size_t> going;
        for (std::size_t i = 0; i < field_->size(); ++i) {
            if (front(i).state == Front::State::Going) going.push_back(i);
        }
        Counters counters;
        advance_fronts(frame_, 0, *field_, going, counters);
    }
    [[nodiscard]] std::size_t size() const { return pixels_.size(); }
    [[nodiscard]] const Front& front(std::size_t i) { return field_->fronts(i).front(); }
    [[nodiscard]] const CoverSquare& square(std::size_t i) const { return field_->square(i); }
    [[nodiscard]] const TileRays& rays() const { return rays_; }
    /// The depth of the first root on the ray of a place of a pixel; +inf: there is none.
    [[nodiscard]] double first_root(std::size_t i, const SquareRay& place) const {
        const double col = SquareField::col_of(square(i), place);
        const double row = SquareField::row_of(square(i), place);
        const glm::dvec3 origin = rays_.point(col, row, 0.0);
        const glm::dvec3 direction = rays_.point(col, row, 1.0) - origin;
        const double a = glm::dot(direction, direction);
        const double b = glm::dot(origin, direction);
        const double c = glm::dot(origin, origin) - square_;
        return b * b < a * c ? none : (-b - std::sqrt(b * b - a * c)) / a;
    }

private:
    double square_;
    Scene scene_;
    TraceFrame frame_;
    Tile tile_{.col = 64, .row = 64, .cols = 64, .rows = 64};
    TileRays rays_;
    std::vector<MixedPixel> pixels_;
    std::optional<SquareField> field_;
};

class Fronts : public testing::TestWithParam<Precision> {};

TEST_P(Fronts, HoldWhatTheySayOfAllRays) {
    const UpwardRounding upward;
    FrontsOfASphere sphere(0.25, aslant, GetParam());
    sphere.advance();
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    int rooted = 0;
    int edged = 0;
    int gone = 0;
    constexpr double error = 1e-14;
    for (std::size_t i = 0; i < sphere.size(); ++i) {
        const Front& front = sphere.front(i);
        for (int k = 0; k < 16; ++k) {
            const double root = sphere.first_root(i, {.x = place(random), .y = place(random)});
            switch (front.state) {
                case Front::State::Going: FAIL() << "a front stopped on its way";
                case Front::State::Rooted:
                    ++rooted;
                    ASSERT_GE(root, front.at - error);
                    ASSERT_LE(root, front.to + error);
                    break;
                case Front::State::Edged:
                    ++edged;
                    ASSERT_GE(root, front.at - error);
                    break;
                case Front::State::Gone:
                    ++gone;
                    ASSERT_EQ(root, none);
                    break;
            }
        }
    }
    EXPECT_GT(rooted, 1000);
    EXPECT_GT(edged, 100);
    EXPECT_GT(gone, 1000);
}

TEST_P(Fronts, EndBesideAnEyeOnTheSurface) {
    const UpwardRounding upward;
    constexpr Camera on_it{
        .eye = {0.3, -0.4, 0.2}, .look_at = {0.1, 0, -0.1}, .up = {0, 0, 1}, .fov_rad = 0.6};
    FrontsOfASphere sphere(0.29, on_it, GetParam());
    sphere.advance();
    for (std::size_t i = 0; i < sphere.size(); ++i)
        ASSERT_NE(sphere.front(i).state, Front::State::Going);
}

INSTANTIATE_TEST_SUITE_P(Numbers, Fronts, testing::Values(Precision::Float, Precision::Double),
                         [](const auto& at) {
                             return at.param == Precision::Float ? "Floats" : "Doubles";
                         });

TEST(FrontBlock, RoundsDepthsOutwardAndKeepsMarks) {
    const UpwardRounding upward;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> depth(-5.0, 5.0);
    FrontBlock<float> floats;
    FrontBlock<double> doubles;
    for (int i = 0; i < 200; ++i) {
        Front front;
        front.at = depth(random);
        front.to = depth(random);
        front.end = depth(random);
        front.open_from = depth(random);
        front.inside_from = depth(random);
        front.inside_to = depth(random);
        front.state = Front::State::Edged;
        front.open_cells = static_cast<std::uint8_t>(i);
        front.kinked = i % 2 == 0;
        front.calm = i % 3 == 0;
        front.placed = i % 5 == 0;
        const auto check = [](double exact, float rounded, bool upward_wanted) {
            const auto value = static_cast<double>(rounded);
            EXPECT_TRUE(upward_wanted ? value >= exact : value <= exact);
            EXPECT_NEAR(value, exact, 5e-7);
        };
        floats.load(0, front);
        check(front.at, floats.at[0], false);
        check(front.to, floats.to[0], true);
        check(front.end, floats.end[0], true);
        check(front.open_from, floats.open_from[0], false);
        check(front.inside_from, floats.inside_from[0], true);
        check(front.inside_to, floats.inside_to[0], false);
        doubles.load(0, front);
        Front again;
        doubles.store(0, again);
        EXPECT_EQ(again.at, front.at);
        EXPECT_EQ(again.to, front.to);
        EXPECT_EQ(again.open_from, front.open_from);
        floats.store(0, again);
        EXPECT_EQ(again.state, front.state);
        EXPECT_EQ(again.open_cells, front.open_cells);
        EXPECT_EQ(again.kinked, front.kinked);
        EXPECT_EQ(again.calm, front.calm);
        EXPECT_EQ(again.placed, front.placed);
        EXPECT_TRUE(again.continuous);
    }
}

TEST(SquareDepths, OfHitsAreThoseOfTheirDistances) {
    const UpwardRounding upward;
    const FrontsOfASphere sphere(0.25, aslant, Precision::Float);
    const TileRays& rays = sphere.rays();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0.0, 63.0);
    SquareDepths squares;
    // Not a whole number of vectors; the last one hits nothing.
    constexpr std::size_t count = 13;
    std::vector<double> depths;
    for (std::size_t i = 0; i < count; ++i) {
        squares.u[i] = rays.u(place(random));
        squares.v[i] = rays.v(place(random));
        depths.push_back(i + 1 < count ? place(random) / 63.0 - 0.5 : none);
        squares.hit[i] = rays.distance_at(depths[i], squares.u[i], squares.v[i]);
    }
    find_hits(rays, count, squares);
    for (std::size_t i = 0; i + 1 < count; ++i)
        EXPECT_NEAR(squares.hit[i], depths[i], 1e-13);
    EXPECT_EQ(squares.hit[count - 1], none);
}

}  // namespace
}  // namespace zeroset::test::fronts_test
