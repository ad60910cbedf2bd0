#pragma once

#include "engine/language/parse.hpp"

#include <array>

namespace zeroset {

/// Along which axes numbers suit that are multiples of pi: those in which some of the program's
/// surfaces repeat themselves after a rational multiple of it, and the others do not depend on the
/// coordinate. Parametric surfaces, curves and points do not count.
std::array<bool, 3> periodic_axes(const Program& program);

}  // namespace zeroset
