#include "tests/support/oracle/piece_roots.hpp"

#include <cmath>
#include <cstddef>

namespace zeroset::test {

RayAnswer first_root(const RayQuestion& ray, const RayPieces& pieces) {
    const std::vector<double>& ends = pieces.ends;
    const double near = 1e-12 * (std::abs(ray.outer_from) + std::abs(ray.outer_to));
    for (std::size_t n = 0; n + 1 < ends.size(); ++n) {
        const double from = ends[n];
        const double to = ends[n + 1];
        // Roots in a piece that is too short are told by its neighbours.
        if (to - from < 4 * near) continue;
        if (pieces.surely_empty && pieces.surely_empty(from, to)) continue;
        const auto f = pieces.polynomial(from + 0.5 * (to - from));
        if (!f) continue;
        const auto oracle = PolynomialOracle::of(*f, {});
        RayQuestion part = ray;
        part.outer_from = from;
        part.outer_to = to;
        const auto roots = oracle->roots(part, 1);
        if (!roots) return hit_between(ray, from - near, from + near, false);
        if (roots->empty()) continue;
        const RayRoot& root = roots->front();
        if (root.from > from + near && root.to < to - near)
            return hit_between(ray, root.from, root.to, root.crosses);
        // Beside a border, where this piece's polynomial is not surely the one that counts.
        const int before = pieces.sign_at(root.from - 4 * near);
        const int after = pieces.sign_at(root.to + 4 * near);
        if (before * after >= 0) return {};
        return hit_between(ray, root.from - 4 * near, root.to + 4 * near, true);
    }
    return {RayTruth::Empty, 0.0, 0.0, false};
}

}  // namespace zeroset::test
