#include "papers/voxels/proved_root.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

using WideNumber = long double;

/// Divisions until a root is narrow, and until one is given up.
constexpr int narrow_halvings = 27, most_halvings = 48;
/// Where parts are divided: not in the middle, where voxels and rays with round numbers often have
/// a root, whose sign nobody knows.
constexpr WideNumber division = 0.4823L;

/// A cubic over [from, to], by its Bernstein coefficients.
struct Part {
    std::array<WideNumber, 4> b{};
    WideNumber from = 0, to = 0;
    int halvings = 0;
};

/// rho at a point of the voxel.
WideNumber density(const VoxelRay& ray, const std::array<WideNumber, 3>& at) {
    WideNumber sum = 0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        WideNumber weight = ray.rho[corner];
        for (std::size_t axis = 0; axis < 3; ++axis)
            weight *= (corner >> axis & 1U) != 0 ? at[axis] : 1 - at[axis];
        sum += weight;
    }
    return sum;
}

Part whole(const VoxelRay& ray) {
    const auto place = [&](std::size_t axis, bool at_end) {
        return WideNumber{ray.a[axis]} +
               (at_end ? WideNumber{ray.t_out} * WideNumber{ray.b[axis]} : 0);
    };
    Part part{.from = 0, .to = ray.t_out};
    std::array<int, 4> count{};
    for (std::size_t ends = 0; ends < 8; ++ends) {
        std::array<WideNumber, 3> at{};
        std::size_t of_end = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool at_end = (ends >> axis & 1U) != 0;
            at[axis] = place(axis, at_end);
            of_end += at_end ? 1 : 0;
        }
        part.b[of_end] += density(ray, at);
        ++count[of_end];
    }
    for (std::size_t k = 0; k < 4; ++k)
        part.b[k] /= count[k];
    return part;
}

/// The two parts of a part, by de Casteljau's algorithm.
std::array<Part, 2> halves(const Part& part) {
    const auto mean = [](WideNumber x, WideNumber y) { return x * (1 - division) + y * division; };
    const auto& b = part.b;
    const std::array first{mean(b[0], b[1]), mean(b[1], b[2]), mean(b[2], b[3])};
    const std::array second{mean(first[0], first[1]), mean(first[1], first[2])};
    const WideNumber middle = mean(second[0], second[1]);
    const WideNumber at = mean(part.from, part.to);
    const int halvings = part.halvings + 1;
    return {Part{.b = {b[0], first[0], second[0], middle},
                 .from = part.from,
                 .to = at,
                 .halvings = halvings},
            Part{.b = {middle, second[1], first[2], b[3]},
                 .from = at,
                 .to = part.to,
                 .halvings = halvings}};
}

/// The first root of a part; numbers no larger than `error` may be 0.
ProvedRoot first_root(const Part& part, WideNumber error) {
    const auto& b = part.b;
    const WideNumber least = *std::ranges::min_element(b);
    const WideNumber largest = *std::ranges::max_element(b);
    if (least > error || largest < -error) return {.kind = ProvedRoot::Kind::None};
    const bool differ = std::min(b[0], b[3]) < -error && std::max(b[0], b[3]) > error;
    if (differ && part.halvings >= narrow_halvings) {
        return {.kind = ProvedRoot::Kind::Root,
                .t = static_cast<double>((part.from + part.to) / 2)};
    }
    if (part.halvings >= most_halvings) return {.kind = ProvedRoot::Kind::Unknown};
    const auto both = halves(part);
    const ProvedRoot first = first_root(both[0], error);
    return first.kind == ProvedRoot::Kind::None ? first_root(both[1], error) : first;
}

}  // namespace

ProvedRoot proved_first_root(const VoxelRay& ray) {
    WideNumber size = 0;
    for (const float rho : ray.rho)
        size = std::max(size, std::abs(WideNumber{rho}));
    // Some 100 roundings of 2^-64 of numbers that are no larger, but for rays a little outside
    return first_root(whole(ray), 0x1p-54L * size);
}

}  // namespace zeroset
