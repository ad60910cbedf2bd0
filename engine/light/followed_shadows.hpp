#pragma once

#include "engine/light/shadow_search.hpp"

namespace zeroset {

/// Searches the ways to the light as the surface's kind follows rays (SurfaceWay::follow): of a
/// level set from where they enter what is visible to its hits, and by single rays only from these
/// to where those begin, and what is left. False, and nothing done: its kind does not. In upward
/// rounding.
bool find_followed_shadows(const ShadowSearch& search, ShadowBits& found, Counters& counters);

}  // namespace zeroset
