#pragma once

#include "engine/light/shadow_search.hpp"

namespace zeroset {

/// Adds to `found` the hits of `search.open` that lie in the shadow of a parametric surface
/// (PatchCode). In upward rounding.
void find_patch_shadows(const ShadowSearch& search, ShadowBits& found, Counters& counters);

}  // namespace zeroset
