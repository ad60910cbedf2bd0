#pragma once

#include <limits>

namespace zeroset {

/// The end of an interval, or a bound of an error, of which nothing is known.
inline constexpr double unbounded = std::numeric_limits<double>::infinity();

}  // namespace zeroset
