#include "engine/light/shadow_kernel.hpp"

#include "engine/kernel/form_cells.hpp"
#include "engine/light/light_walls.hpp"
#include "engine/real/scalar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace zeroset {
namespace {

constexpr std::size_t slabs = batch_multiple;

/// A rectangle of the light's rays, and the depths that matter to it.
struct Column {
    double u, v, u_radius, v_radius;
    double from, to;
};

/// All that lies between the hits and the light.
Column column_of(const ShadowSearch& search, const Square& square) {
    constexpr float none = std::numeric_limits<float>::infinity();
    PlaceBounds all{.u = {none, -none}, .v = {none, -none}, .s = {none, -none}, .h = {}};
    const auto widen = [](float* ends, const float* by) {
        ends[0] = std::min(ends[0], by[0]);
        ends[1] = std::max(ends[1], by[1]);
    };
    const auto side = std::min<std::uint8_t>(square.side, 8);
    for (unsigned row = 0; row < square.side; row += side) {
        for (unsigned col = 0; col < square.side; col += side) {
            const Square part{.col = static_cast<std::uint8_t>(square.col + col),
                              .row = static_cast<std::uint8_t>(square.row + row),
                              .side = side};
            const PlaceBounds bounds = bounds_of(search.places, search.open, part, 0.0F, 0.0F);
            widen(all.u, bounds.u);
            widen(all.v, bounds.v);
            widen(all.s, bounds.s);
        }
    }
    const auto middle = [](const float* ends) {
        return static_cast<double>(0.5F * ends[0] + 0.5F * ends[1]);
    };
    const auto radius = [&](const float* ends) {
        return std::max(static_cast<double>(ends[1]) - middle(ends),
                        middle(ends) - static_cast<double>(ends[0])) +
               search.places.error;
    };
    Column column{.u = middle(all.u),
                  .v = middle(all.v),
                  .u_radius = radius(all.u),
                  .v_radius = radius(all.v),
                  .from = 0.0,
                  .to = static_cast<double>(all.s[1]) + search.places.error};
    const LightWalls walls(search.rays);
    column.from = walls
                      .entry(column.u, column.v, column.u_radius, column.v_radius,
                             {.middle = 0.0, .by_u = 0.0, .by_v = 0.0})
                      .first;
    return column;
}

template <class Real>
std::shared_ptr<const Kernel> specialized(const ShadowSearch& search, const Column& column) {
    constexpr auto unit = static_cast<double>(std::numeric_limits<Real>::epsilon());
    const double per_distance = 1.0 / search.rays.distance();
    const double length = (column.to - column.from) / slabs;
    const double farthest = std::max(std::abs(column.from), std::abs(column.to));
    // Boxes about slanted cells reach out of the column by what they are aside.
    const double margin = length + 256 * unit * farthest + 16 * search.places.error;
    const double wider = 1.0 + 0x1p-10;
    FrustumOf<Real> frustum = search.rays.frustum<Real>(1);
    frustum.u_radius = upper_end(Real{}, wider * column.u_radius * per_distance);
    frustum.v_radius = upper_end(Real{}, wider * column.v_radius * per_distance);
    FormCells<Real, slabs> cells;
    for (std::size_t i = 0; i < slabs; ++i) {
        cells.u[i] = static_cast<Real>(column.u * per_distance);
        cells.v[i] = static_cast<Real>(column.v * per_distance);
        cells.s[i] = static_cast<Real>(column.from + (static_cast<double>(i) + 0.5) * length);
        cells.s_radius[i] = upper_end(Real{}, 0.5 * length + margin);
    }
    ChoiceRecord record;
    search.light.kernel.specializer->form(
        cells.batch(slabs, frustum, search.light.scene.uniforms.template boxes<Real>()), record);
    std::array<std::size_t, slabs> all{};
    std::iota(all.begin(), all.end(), std::size_t{0});
    return search.light.kernel.specializer->specialized(record, all);
}

}  // namespace

std::shared_ptr<const Kernel> kernel_before_hits(const ShadowSearch& search, const Square& square) {
    if (search.light.kernel.specializer == nullptr) return nullptr;
    const Column column = column_of(search, square);
    if (!(column.from < column.to)) return nullptr;
    return search.light.precision == Precision::Double ? specialized<double>(search, column)
                                                       : specialized<float>(search, column);
}

}  // namespace zeroset
