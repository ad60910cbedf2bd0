#include "engine/kernel/form_cells.hpp"
#include "engine/light/shadow_search.hpp"
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
    PlaceBounds all;
    const auto side = std::min<std::uint8_t>(square.side, 8);
    for (unsigned row = 0; row < square.side; row += side) {
        for (unsigned col = 0; col < square.side; col += side) {
            const Square part{.col = static_cast<std::uint8_t>(square.col + col),
                              .row = static_cast<std::uint8_t>(square.row + row),
                              .side = side};
            const PlaceBounds bounds = bounds_of(search.places, search.open, part, 0.0F, 0.0F);
            all.u.widen(bounds.u);
            all.v.widen(bounds.v);
            all.s.widen(bounds.s);
        }
    }
    const double error = search.places.error;
    Column column{.u = all.u.middle(),
                  .v = all.v.middle(),
                  .u_radius = all.u.radius() + error,
                  .v_radius = all.v.radius() + error,
                  .from = 0.0,
                  .to = static_cast<double>(all.s.greatest) + error};
    const Plane plane{.middle = 0.0, .by_u = 0.0, .by_v = 0.0};
    column.from =
        search.walls.entry(column.u, column.v, column.u_radius, column.v_radius, plane).first;
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
