#pragma once

#include "engine/trace/surface_way.hpp"

namespace zeroset {

/// The way of a surface's kind. Any thread.
const SurfaceWay& way_of(const Kernel& surface);

}  // namespace zeroset
