#include "engine/scene/precision.hpp"

#include "engine/base/enum_names.hpp"
#include "engine/kernel/float_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {

std::string_view name_of(Precision precision) {
    return enum_names<Precision>("float", "double").of(precision);
}

SearchDepth search_depth(const Box& clip, const ViewFrame& view, const StopCriterion& stop) {
    constexpr double deepest = 100.0;  // below the resolution of any type
    const double share = clip.size() / view.look_distance;
    const double deeper = share > 1.0 ? std::min(std::floor(std::log2(share)), deepest) : 0.0;
    const double own = stop.rule == StopRule::DStop ? stop.value : max_d_stop;
    return {.wanted = static_cast<int>(own) + static_cast<int>(deeper),
            .deeper = static_cast<int>(deeper)};
}

int deepest_halving(const Box& clip, double reach, int digits) {
    const double finest = std::ldexp(1.0, std::ilogb(reach) + 3 - digits);
    return std::max(1, std::ilogb(clip.size() / finest));
}

Precision wanted_precision(const Box& clip, const ViewFrame& view, const StopCriterion& stop) {
    // The eye is no farther from the point looked at than half the box's edge.
    constexpr int deep_view = 1;
    // Enclosures of f in float are as wide as those of cells of some 2^6 ulp.
    constexpr int lost_bits = 6;
    const glm::dvec3 far = glm::max(glm::abs(clip.lo), glm::abs(clip.hi));
    const double reach = std::max({far.x, far.y, far.z});
    const int possible = deepest_halving(clip, reach, std::numeric_limits<float>::digits);
    const SearchDepth depth = search_depth(clip, view, stop);
    const bool whole = depth.deeper < deep_view && depth.wanted <= max_d_stop &&
                       possible >= max_d_stop - most_missed_halvings;
    return !whole && depth.wanted + lost_bits > possible ? Precision::Double : Precision::Float;
}

Precision wanted_precision(const Scene& scene, const ViewFrame& view, const StopCriterion& stop) {
    const Box& clip = scene.clip;
    const bool floats_suffice = std::ranges::all_of(scene.surfaces, [&](const Surface& surface) {
        const FloatCheck* const check = surface.kernel.float_check.get();
        return check == nullptr ||
               check->suffices({clip.lo.x, clip.lo.y, clip.lo.z}, {clip.hi.x, clip.hi.y, clip.hi.z},
                               scene.uniforms);
    });
    return floats_suffice ? wanted_precision(clip, view, stop) : Precision::Double;
}

}  // namespace zeroset
