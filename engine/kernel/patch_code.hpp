#pragma once

#include "engine/kernel/kernel.hpp"

#include <array>

namespace zeroset {

/// The code of a parametric surface: where x and y are in the unit square, the point is
/// (point[0], point[1], point[2]). The kernels have code in double (Kernel::has_double); z is 0.
struct PatchCode {
    std::array<Kernel, 3> point;
};

/// The kernel of a surface that is drawn by its patch. Its functions know nothing of any place, so
/// that whoever asks them for an f finds no root and proves nothing.
Kernel patch_kernel(std::array<Kernel, 3> point);

}  // namespace zeroset
