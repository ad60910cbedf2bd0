#pragma once

#include "engine/trace/patch/patch_sight.hpp"
#include "engine/trace/patch/patch_tree.hpp"
#include "engine/view/box.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

// The parts of a node as the rays of a tile see them, all at once.

namespace zeroset {

/// Some rays in the image plane; none where lo > hi.
struct RayBounds {
    double u_lo, u_hi, v_lo, v_hi;
};

/// The rays, the clip box and the depths in which parts are seen.
struct PartWindow {
    const SightAxes& axes;
    const RayBounds& rays;
    const Box& clip;
    SightDepths depths;  ///< between which something is wanted
};

/// The parts in the axes of a view.
struct SeenParts {
    using Numbers = std::array<std::array<double, PatchForms::at_once>, 3>;

    alignas(64) Numbers c;
    Numbers kp, kq, e;
    std::array<double, PatchForms::at_once> value_error;

    /// place_of a part.
    [[nodiscard]] PatchSight sight(std::size_t part) const {
        const auto vector = [&](const Numbers& numbers) {
            return glm::dvec3(numbers[0][part], numbers[1][part], numbers[2][part]);
        };
        PatchSight sight;
        sight.c = vector(c);
        sight.kp = vector(kp);
        sight.kq = vector(kq);
        sight.e = vector(e);
        sight.value_error = value_error[part];
        return sight;
    }
};

/// A bit for each part that rays may meet, of those that PartForms knows; sets what is seen of all
/// of them. In upward rounding.
std::uint32_t see_parts(const PartForms& forms, const PartWindow& window, SeenParts& seen);

}  // namespace zeroset
