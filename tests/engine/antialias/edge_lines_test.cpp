#include "engine/antialias/edge_lines.hpp"

#include "engine/antialias/edge_fit.hpp"
#include "engine/antialias/half_square.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

// Lines of edges in many squares, against the fit of one square after the other.

namespace zeroset::test::edge_lines_test {
namespace {

constexpr Camera aslant{
    .eye = {3, -4, 2.5}, .look_at = {0.1, 0, -0.1}, .up = {0, 0, 1}, .fov_rad = 0.5};

class EdgeLinesTest : public testing::TestWithParam<std::string> {
protected:
    using Five = std::array<RayStretch, square_ray_count>;

    /// The edge lines of squares around pixels in a row, of so many pixels' side.
    const EdgeLines& lines_of(int row, double side, bool all_rays, const LineRules& rules,
                              std::size_t count) {
        squares_.side = side;
        squares_.rules = rules;
        squares_.all_rays = all_rays;
        squares_.count = count;
        for (std::size_t i = 0; i < count; ++i) {
            squares_.col[i] = static_cast<double>(i);
            squares_.row[i] = row;
            squares_.from[i] = from;
            squares_.to[i] = to;
        }
        find_lines(frame_, rays_, squares_, counters_);
        return squares_;
    }
    /// The stretches of a square's rays, one by one.
    Five stretches_of(std::size_t col, int row, double side) {
        Five five{};
        for (std::size_t k = 0; k < square_ray_count; ++k)
            five[k] = {.col = static_cast<double>(col) + 0.5 * side * square_rays[k].x,
                       .row = row + 0.5 * side * square_rays[k].y,
                       .from = from,
                       .to = to};
        find_least(frame_, rays_, five, counters_);
        return five;
    }

    static constexpr double from = -0.9, to = 1.1;

    const UpwardRounding upward_;
    Scene scene_ = scene_of(GetParam(), Box::cube(1.5));
    ViewFrame view_{aslant};
    ImageSize image_{.width = 192, .height = 192};
    StopCriterion stop_;
    TraceFrame frame_ = trace_frame(scene_, scene_.surfaces.front(), view_, image_, stop_);
    Tile tile_{.col = 64, .row = 64, .cols = 64, .rows = 64};
    TileRays rays_{frame_, tile_};
    Counters counters_;
    EdgeLines squares_{};
};

constexpr LineRules strict{.error = 1.0 / 68, .flat_too = false, .may_hide = true};

bool has_one_sign(const std::array<RayStretch, square_ray_count>& five) {
    return std::ranges::all_of(
        five, [&](const RayStretch& ray) { return (ray.near >= 0.0) == (five[0].near >= 0.0); });
}

bool is_hidden(const std::array<RayStretch, square_ray_count>& five, const EdgeSamples& samples) {
    return samples.roots() == 0 &&
           std::ranges::none_of(five, [](const RayStretch& ray) { return ray.inner; });
}

TEST_P(EdgeLinesTest, OfAllRaysAreThoseOfEachSquare) {
    for (int row = 0; row < 64; row += 3) {
        for (const bool flat_too : {false, true}) {
            LineRules rules = strict;
            rules.flat_too = flat_too;
            const EdgeLines& found = lines_of(row, 0.5, true, rules, 23);
            for (std::size_t i = 0; i < found.count; ++i) {
                const Five five = stretches_of(i, row, 0.5);
                const EdgeSamples samples = edge_samples(five);
                // Whether heights are just on a line is decided in other orders of sums.
                const auto fit = fit_edge(samples, 1.000001 * rules.error, flat_too);
                const bool is_line = fit && !is_hidden(five, samples);
                const auto surely = fit_edge(samples, 0.999999 * rules.error, flat_too);
                const bool is_surely_line =
                    surely && has_one_sign(five) && !is_hidden(five, samples);
                ASSERT_TRUE(found.is_line[i] != 0.0 ? is_line : !is_surely_line) << row;
                if (found.is_line[i] == 0.0) continue;
                const SquarePart part = part_below_zero(*fit);
                ASSERT_NEAR(found.share[i], part.share, 1e-6);
                ASSERT_NEAR(found.x[i], part.x, 1e-5);
                ASSERT_NEAR(found.y[i], part.y, 1e-5);
                for (std::size_t k = 0; k < square_ray_count; ++k)
                    ASSERT_EQ((static_cast<unsigned>(found.hits[i]) >> k & 1U) != 0,
                              !samples.misses()[k]);
            }
        }
    }
}

TEST_P(EdgeLinesTest, OfTheMiddleRayAreThoseOfAll) {
    std::size_t lines = 0;
    std::size_t lines_of_all = 0;
    for (int row = 0; row < 64; ++row) {
        const EdgeLines& found = lines_of(row, 1.0, false, strict, EdgeLines::capacity);
        for (std::size_t i = 0; i < found.count; ++i) {
            const Five five = stretches_of(i, row, 1.0);
            const EdgeSamples samples = edge_samples(five);
            if (fit_edge(samples, strict.error, false) && !is_hidden(five, samples)) ++lines_of_all;
            if (found.is_line[i] == 0.0) continue;
            ++lines;
            const auto fit = fit_edge(samples, 1.5 * strict.error, false);
            ASSERT_TRUE(fit) << row << ' ' << i;
            const SquarePart part = part_below_zero(*fit);
            ASSERT_NEAR(found.share[i], part.share, 1e-3);
            if (part.share < 0.01) continue;
            ASSERT_NEAR(found.x[i], part.x, 0.02);
            ASSERT_NEAR(found.y[i], part.y, 0.02);
        }
    }
    // Most of them are found so, except of two sheets that meet.
    EXPECT_GE(lines, lines_of_all > 100 ? lines_of_all / 2 : 0);
}

TEST_P(EdgeLinesTest, TellTheStretchesOfOtherSquares) {
    const EdgeLines& found = lines_of(30, 1.0, true, strict, EdgeLines::capacity_of_all_rays);
    for (std::size_t i = 0; i < found.count; ++i) {
        if (found.is_line[i] != 0.0) continue;
        const Five five = stretches_of(i, 30, 1.0);
        for (std::size_t k = 0; k < square_ray_count; ++k) {
            const RayStretch& told = found.stretches[i][k];
            ASSERT_EQ(told.col, five[k].col);
            ASSERT_EQ(told.row, five[k].row);
            ASSERT_EQ(told.from, from);
            ASSERT_EQ(told.to, to);
            ASSERT_EQ(told.inner, five[k].inner);
            ASSERT_NEAR(told.near, five[k].near, 1e-12);
            ASSERT_NEAR(told.least, five[k].least, 1e-6);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, EdgeLinesTest,
                         testing::Values("x^2 + y^2 + z^2 = 0.25",  // smooth edges
                                         "x^2 + z^2 = 0.000001",  // a thread, thinner than a pixel
                                         "(x^2 + y^2 + z^2 - 0.3)^2 = 0.001",  // two sheets
                                         "x^3 y + y^3 z + z^3 x + 0.1 x = 0",  // edges that end
                                         "x + 0.2 y = 0.1 z^2"));              // one sheet

}  // namespace
}  // namespace zeroset::test::edge_lines_test
