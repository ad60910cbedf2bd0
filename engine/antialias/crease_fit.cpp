#include "engine/antialias/edge_fit.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// Normals whose directions have at least this cosine are of one sheet; and of an even one.
constexpr double one_sheet = 0.97;
constexpr double even_sheet = 0.9995;
/// Rays at more than 60 degrees from the normal graze.
constexpr double least_root_cosine = 0.5;

bool are_within(double cosine, const RayRoot& a, const RayRoot& b) {
    // False where a gradient is NaN.
    return glm::dot(a.gradient, b.gradient) >=
           cosine * glm::length(a.gradient) * glm::length(b.gradient);
}

bool are_of_one_sheet(const RayRoot& a, const RayRoot& b) { return are_within(one_sheet, a, b); }

/// The depth of the sheet's tangent plane at a ray's root, over the square.
LinearOnSquare plane_at(const RayRoot& root, const SquareRay& ray, double half_side) {
    const double by_x = half_side * root.by_col;
    const double by_y = half_side * root.by_row;
    return {.value = root.s - by_x * ray.x - by_y * ray.y, .by_x = by_x, .by_y = by_y};
}

}  // namespace

std::optional<Creased> fit_crease(SquareRoots roots, double half_side) {
    // The sheet of the middle's root, and the other one.
    std::array<bool, square_ray_count> is_other{};
    std::size_t other = 0;
    for (std::size_t i = 1; i < square_ray_count; ++i) {
        if (are_of_one_sheet(roots[0], roots[i])) continue;
        is_other[i] = true;
        if (other == 0) other = i;
        if (!are_of_one_sheet(roots[other], roots[i])) return std::nullopt;
    }
    const SquarePart whole{.share = 1.0, .x = 0.0, .y = 0.0};
    const SquarePart nothing{.share = 0.0, .x = 0.0, .y = 0.0};
    if (!are_of_one_sheet(roots[0], roots[0])) return std::nullopt;
    const bool grazed = !std::ranges::all_of(
        roots, [](const RayRoot& root) { return root.cosine > least_root_cosine; });
    if (other == 0) {
        const bool bent = !std::ranges::all_of(
            roots, [&](const RayRoot& root) { return are_within(even_sheet, roots[0], root); });
        return Creased{.parts = {whole, nothing}, .rays = {0, 0}, .grazed = grazed, .bent = bent};
    }
    // The sheets meet where they are equally deep; the nearer one is seen, or the farther one.
    LinearOnSquare farther = plane_at(roots[0], square_rays[0], half_side) -
                             plane_at(roots[other], square_rays[other], half_side);
    if (farther.at(square_rays[0]) > 0.0) farther = -farther;
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        // A depth that is NaN fits no sheet.
        if (!((farther.at(square_rays[i]) > 0.0) == is_other[i]) ||
            !std::isfinite(farther.at(square_rays[i])))
            return std::nullopt;
    }
    return Creased{.parts = {part_below_zero(farther), part_below_zero(-farther)},
                   .rays = {0, other},
                   .grazed = grazed};
}

}  // namespace zeroset
