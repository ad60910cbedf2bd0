#pragma once

#include "engine/expr/parts.hpp"

#include <cstdint>

namespace zeroset {

/// The code of a part's shape with the part's constants. Neither it nor a copy outlives `parts`.
Kernel kernel_of_part(const Parts& parts, std::uint32_t part);

}  // namespace zeroset
