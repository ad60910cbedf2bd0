#include "engine/scene/tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {

std::optional<double> certified_width(const Box& clip, const StopCriterion& stop,
                                      Precision precision) {
    if (stop.rule != StopRule::DStop) return std::nullopt;
    const int digits = precision == Precision::Double ? std::numeric_limits<double>::digits
                                                      : std::numeric_limits<float>::digits;
    int depth = static_cast<int>(stop.value);
    for (int i = 0; i < 3; ++i) {
        const double reach = std::max(std::abs(clip.lo[i]), std::abs(clip.hi[i]));
        depth = std::min(depth, deepest_halving(clip, reach, digits));
    }
    return (1 + extra_slices) * std::ldexp(clip.size(), -depth);
}

}  // namespace zeroset
