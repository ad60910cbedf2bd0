#include "engine/trace/tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {

int bisections(const Box& clip, double k_size, const StopCriterion& stop) {
    const double finest = std::ldexp(1.0, std::ilogb(k_size) + 2 - 23);
    const bool by_d_stop = stop.rule == StopRule::DStop;
    const int wanted = by_d_stop ? static_cast<int>(stop.value) : max_d_stop;
    return std::max(1, std::min(wanted, std::ilogb(clip.size() / finest)));
}

std::optional<double> certified_width(const Box& clip, const StopCriterion& stop) {
    if (stop.rule != StopRule::DStop) return std::nullopt;
    int depth = max_d_stop;
    for (int i = 0; i < 3; ++i) {
        const double k_size = std::max(std::abs(clip.lo[i]), std::abs(clip.hi[i]));
        depth = std::min(depth, bisections(clip, k_size, stop));
    }
    return (1 + extra_slices) * std::ldexp(clip.size(), -depth);
}

}  // namespace zeroset
