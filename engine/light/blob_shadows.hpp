#pragma once

#include "engine/light/shadow_search.hpp"

namespace zeroset {

/// Searches a plain surface of soft balls by those near each ray, and by single rays only from its
/// hits to where these begin, and what is left. False, and nothing done: it is no such surface. In
/// upward rounding.
bool find_blob_shadows(const ShadowSearch& search, ShadowBits& found, Counters& counters);

}  // namespace zeroset
