#pragma once

#include "engine/expr/kernel.hpp"

namespace zeroset {

/// The functions over rays of a kernel whose functions over points are known; slower than code of
/// their own. For code without: interpreted or shortened.
void add_ray_functions(Kernel& kernel);

/// The same for a kernel that stays where it is, and is not copied beyond its life.
void add_ray_functions_in_place(Kernel& kernel);

}  // namespace zeroset
