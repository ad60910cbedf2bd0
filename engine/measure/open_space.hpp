#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/scene/open_space.hpp"

#include <cstdint>

namespace zeroset {

/// The finest grid: 2^7 cells along each axis.
inline constexpr int most_open_levels = 7;

struct OpenSpaceSearch {
    OpenSpace space;
    std::uint64_t ranges = 0;  ///< evaluations that it took, in boxes
};

/// Finds where in the box the surface may be, by natural interval extensions over the box's
/// octants and theirs, `levels` times, at least once. `uniforms` may be wide: what is proved holds
/// for all of their values. With `jumps` places where f changes its sign without a root are open,
/// too. On `threads` cores (0: all).
OpenSpaceSearch find_open_space(const Kernel& surface, const Box& box, const Uniforms& uniforms,
                                int levels, bool jumps, int threads);

}  // namespace zeroset
