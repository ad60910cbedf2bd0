#pragma once

#include <string_view>

namespace zeroset {

/// The statement by which theta and phi change places, as physics has them.
inline constexpr std::string_view angles_swapped = "swap theta, phi";

}  // namespace zeroset
