#pragma once

#include "engine/light/shadow_search.hpp"

#include <memory>

namespace zeroset {

/// The surface's kernel for all that lies between the light and the hits that are asked about, all
/// in a square of the tile; nullptr where it would not be shorter. It outlives no kernel that it is
/// made from. In upward rounding.
std::shared_ptr<const Kernel> kernel_before_hits(const ShadowSearch& search, const Square& square);

}  // namespace zeroset
