#include "engine/trace/voxels/level_grid.hpp"

#include "engine/trace/voxels/block_lanes.hpp"
#include "engine/volume/spline.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

// Slabs of a grid whose room was filled with garbage before: what is found of rays must not depend
// on it, and no ray whose polynomial has a root in a layer may be left out.

namespace zeroset::test::level_grid_test {
namespace {

using Cell = std::array<std::int32_t, 3>;

constexpr GridSize size{29, 26, 33};

/// Waves with noise, so that slabs have cells that hold the level and cells that do not.
std::shared_ptr<const VolumeData> waves() {
    RandomNumbers random(5);
    const auto numbers = std::make_shared<std::vector<float>>();
    for (std::uint64_t n = 0; n < size[0] * size[1] * size[2]; ++n) {
        const auto i = static_cast<double>(n % size[0]);
        const auto j = static_cast<double>(n / size[0] % size[1]);
        const auto k = static_cast<double>(n / (size[0] * size[1]));
        const double wave = std::sin(0.5 * i + 0.2 * k) + std::cos(0.45 * j - 0.3 * k);
        numbers->push_back(static_cast<float>(wave + random.uniform(-0.3, 0.3)));
    }
    const auto data =
        VolumeData::make({.type = SampleType::Float,
                          .size = size,
                          .data = std::shared_ptr<const void>(numbers, numbers->data())},
                         Geometry{});
    return data.value();
}

/// The contents of a slab's room before it is filled.
struct Garbage {
    float sample;
    SampleBits bits;
};
constexpr std::uint64_t all_bits = ~std::uint64_t{0};
constexpr std::array garbage{
    Garbage{.sample = 0, .bits = {.above = 0, .below = 0}},
    Garbage{.sample = std::numeric_limits<float>::quiet_NaN(),
            .bits = {.above = all_bits, .below = 0}},
    Garbage{.sample = 1e30F, .bits = {.above = all_bits, .below = all_bits}},
    Garbage{.sample = -1e30F, .bits = {.above = 0, .below = all_bits}},
};

/// Rays of a bundle along an axis, some of which are open.
struct Rays {
    RayColumns columns;
    std::uint64_t open = 0;
    double steepest = 0;
};

/// Rays side by side as a bundle's are, or spread wider; they are known where the axis is at `k`.
Rays random_rays(RandomNumbers& random, const WalkAxes& axes, double k) {
    Rays rays;
    const double width = random.uniform(0.2, 1.5);
    const auto last = [&](std::size_t axis) { return static_cast<double>(size[axis]) - 1; };
    const double i = random.uniform(-2, last(axes.i) - 2);
    const double j = random.uniform(-2, last(axes.j) - 2);
    const double i_slope = random.uniform(-1.4, 1.4);
    const double j_slope = random.uniform(-1.4, 1.4);
    for (std::size_t ray = 0; ray < block_rays; ++ray) {
        const auto col = static_cast<double>(ray % 8);
        const auto row = static_cast<double>(ray / 8);
        RayColumns& to = rays.columns;
        to.i_slope[ray] = i_slope + 0.005 * col;
        to.j_slope[ray] = j_slope + 0.005 * row;
        to.i_at[ray] = i + width * col - k * to.i_slope[ray];
        to.j_at[ray] = j + width * row - k * to.j_slope[ray];
        rays.steepest =
            std::max({rays.steepest, std::abs(to.i_slope[ray]), std::abs(to.j_slope[ray])});
    }
    const std::size_t kept = 1 + random.below(3);  // open rays: every one, or every second ...
    for (std::size_t ray = 0; ray < block_rays; ++ray) {
        if (random.one_in(kept)) rays.open |= std::uint64_t{1} << ray;
    }
    if (random.one_in(3)) rays.open &= 0xffff;  // two rows
    if (rays.open == 0) rays.open = 1;
    return rays;
}

/// The findings in a slab: the marked cells that rays may be in, and the rays, layer by layer.
struct Found {
    std::vector<std::array<std::uint64_t, CellMask::most_cells>> cells;
    std::vector<std::uint64_t> rays;

    bool operator==(const Found&) const = default;
};

template <std::size_t support>
class Slabs {
public:
    Slabs(const Pyramid<float>& pyramid, const Samples& samples)
        : grid_(pyramid, samples.size, static_cast<const float*>(samples.data.get()), level,
                1e-12) {}

    /// Asks about a slab, up or down.
    Found ask(const Rays& rays, const LayerRange& layers, const WalkAxes& axes, bool up,
              const Garbage& before) {
        Found found;
        const RayReach reach(rays.columns, layers, rays.open);
        const CellRectangle whole{.i_first = 0,
                                  .i_last = static_cast<std::int32_t>(size[axes.i]) - 2,
                                  .j_first = 0,
                                  .j_last = static_cast<std::int32_t>(size[axes.j]) - 2};
        const CellRectangle near = whole.common(reach.cells(layers.low, layers.high));
        if (near.empty()) return found;
        const CellRectangle held = grid_.in_bricks(near, layers, axes);
        if (held.empty() || !CellMask::fits(held)) return found;
        CellMask mask;
        mask.samples.numbers.fill(before.sample);
        for (auto& face : mask.faces)
            face.fill(before.bits);
        grid_.begin(held, layers, axes, mask);
        if (!mask.is_small()) return found;
        SlabRays slab_rays;
        count_from(rays.columns, held.i_first, held.j_first, layers.low, slab_rays);
        for (std::int32_t n = 0; n <= layers.high - layers.low; ++n) {
            const std::int32_t layer = up ? layers.low + n : layers.high - n;
            grid_.mark(layer, reach, axes, mask);
            auto& cells = found.cells.emplace_back();
            for (std::size_t row = mask.rows.first; row <= mask.rows.last; ++row)
                cells[row] = mask.bits[row];
            const NearCells marked = mask.near(rays.steepest);
            const AskedLayer asked{.samples = mask.samples,
                                   .marked = marked,
                                   .layer = static_cast<std::size_t>(layer - layers.low),
                                   .rows = mask.rows,
                                   .is_spline = support == 4,
                                   .error = mask.error};
            found.rays.push_back(rays_at_level(slab_rays, asked, rays.open));
            check(rays, layer, axes, found.rays.back(), mask);
        }
        return found;
    }

    int roots = 0, left_out = 0;

private:
    /// f on the ray in a cell; the ends are where it is in cell and layer.
    struct Piece {
        Cell cell;
        double first = 0, last = 0;  ///< f at both ends
    };
    /// The ray in the layer, in pieces so short that each is in one cell.
    template <class Take>
    void for_each_piece(const Rays& rays, std::size_t ray, std::int32_t layer, const WalkAxes& axes,
                        const Take& take) const {
        constexpr int pieces = 16;
        for (int n = 0; n < pieces; ++n) {
            std::array<std::array<double, 3>, 2> places{};
            for (int end = 0; end < 2; ++end) {
                // Away from the ends of the piece
                const double k = layer + (n + (end == 0 ? 0.01 : 0.99)) / pieces;
                auto& place = places[static_cast<std::size_t>(end)];
                place[axes.i] = rays.columns.i_at[ray] + k * rays.columns.i_slope[ray];
                place[axes.j] = rays.columns.j_at[ray] + k * rays.columns.j_slope[ray];
                place[axes.k] = k;
            }
            Piece piece{};
            bool inside = true;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double cell = std::floor(places[0][axis]);
                inside = inside && cell == std::floor(places[1][axis]) && cell >= 0 &&
                         cell <= static_cast<double>(size[axis]) - 2;
                piece.cell[axis] = static_cast<std::int32_t>(cell);
            }
            if (!inside) continue;
            for (auto& place : places) {
                for (std::size_t axis = 0; axis < 3; ++axis)
                    place[axis] -= piece.cell[axis];
            }
            const auto f = ray_polynomial(grid_.numbers(piece.cell), places[0], places[1], 0, 1);
            piece.first = f.b.front();
            piece.last = f.b.back();
            take(piece);
        }
    }
    /// Expects the rays that surely have a root in the layer among those that were found, and the
    /// cells of these roots marked.
    void check(const Rays& rays, std::int32_t layer, const WalkAxes& axes, std::uint64_t found,
               const CellMask& mask) {
        for (std::size_t ray = 0; ray < block_rays; ++ray) {
            if ((rays.open >> ray & 1U) == 0) continue;
            bool crosses = false;
            for_each_piece(rays, ray, layer, axes, [&](const Piece& piece) {
                if (!(piece.first * piece.last < 0)) return;
                crosses = true;
                EXPECT_TRUE(mask.may_hold(piece.cell[axes.i], piece.cell[axes.j]))
                    << "a cell with a root on ray " << ray << " is not marked";
            });
            const bool is_found = (found >> ray & 1U) != 0;
            roots += crosses ? 1 : 0;
            left_out += is_found ? 0 : 1;
            EXPECT_TRUE(!crosses || is_found) << "ray " << ray << " in layer " << layer;
        }
    }

    static constexpr double level = 0.2;
    LevelGrid<float, support> grid_;
};

template <std::size_t support>
void expect_nothing_unread(const Pyramid<float>& pyramid, const Samples& samples) {
    Slabs<support> slabs(pyramid, samples);
    RandomNumbers random(17);
    int looked_at = 0;
    for (int n = 0; n < 240 && !testing::Test::HasFailure(); ++n) {
        SCOPED_TRACE(n);
        const auto along = static_cast<std::size_t>(n % 3);
        const WalkAxes axes{
            .i = along == 0 ? std::size_t{1} : 0, .j = along == 2 ? std::size_t{1} : 2, .k = along};
        const auto last = static_cast<int>(size[along]) - 2;
        const std::int32_t low = random.between(0, last) / 4 * 4 + random.between(0, 3);
        if (low > last) continue;
        const std::int32_t high = std::min(low / 4 * 4 + 3, last);
        const LayerRange layers{.low = low, .high = random.between(low, high)};
        const Rays rays = random_rays(random, axes, low);
        const bool up = random.one_in(2);
        const Found first = slabs.ask(rays, layers, axes, up, garbage[0]);
        looked_at += first.rays.empty() ? 0 : 1;
        for (const Garbage& before : garbage) {
            EXPECT_EQ(slabs.ask(rays, layers, axes, up, before), first)
                << "what is found depends on what " << before.sample << " left";
        }
    }
    EXPECT_GT(looked_at, 60);
    EXPECT_GT(slabs.roots, 3000);
    EXPECT_GT(slabs.left_out, 3000);
}

TEST(LevelGrid, ReadsNothingOfSlabsThatWasNotLoaded) {
    const auto data = waves();
    expect_nothing_unread<2>(data->pyramid<float>(), data->samples());
}

TEST(LevelGrid, ReadsNothingOfSplinesThatWasNotLoaded) {
    const auto spline = SplineData::of(waves(), SplineKind::Smoothing).value();
    expect_nothing_unread<4>(spline->pyramid<float>(), spline->coefficients());
}

}  // namespace
}  // namespace zeroset::test::level_grid_test
