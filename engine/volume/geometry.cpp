#include "engine/volume/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

using Wide = long double;

/// The cofactor of row r and column c.
Wide cofactor(const Matrix3& m, std::size_t r, std::size_t c) {
    const std::size_t r1 = (r + 1) % 3;
    const std::size_t r2 = (r + 2) % 3;
    const std::size_t c1 = (c + 1) % 3;
    const std::size_t c2 = (c + 2) % 3;
    return Wide{m[r1][c1]} * m[r2][c2] - Wide{m[r1][c2]} * m[r2][c1];
}

bool all_finite(const auto& numbers) {
    return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

}  // namespace

std::optional<IndexMap> index_map(const Geometry& geometry) {
    const Matrix3& m = geometry.world_from_index;
    Wide determinant = 0;
    Wide volume = 1;  // of a box with edges as long as the axes
    for (std::size_t c = 0; c < 3; ++c) {
        determinant += m[0][c] * cofactor(m, 0, c);
        volume *= std::hypot(Wide{m[0][c]}, Wide{m[1][c]}, Wide{m[2][c]});
    }
    constexpr Wide flattest = 1e-6L;
    if (!(std::abs(determinant) > flattest * volume)) return std::nullopt;
    IndexMap map{};
    for (std::size_t r = 0; r < 3; ++r) {
        Wide shift = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            map.index_from_world[r][c] = static_cast<double>(cofactor(m, c, r) / determinant);
            shift -= Wide{map.index_from_world[r][c]} * geometry.origin[c];
        }
        map.shift[r] = static_cast<double>(shift);
        if (!all_finite(map.index_from_world[r])) return std::nullopt;
    }
    if (!all_finite(map.shift)) return std::nullopt;
    return map;
}

std::array<double, 3> world_point(const Geometry& geometry, const std::array<double, 3>& index) {
    std::array<double, 3> point = geometry.origin;
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c)
            point[r] += geometry.world_from_index[r][c] * index[c];
    }
    return point;
}

}  // namespace zeroset
