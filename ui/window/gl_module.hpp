#pragma once

#include "ui/window/gl.hpp"

// A library that stands in for libGL where pictures are drawn off screen. Dear ImGui's renderer
// asks libGL for OpenGL's functions, whatever the context is, and libGL knows nothing of OSMesa's.
// The library has libGL's name for the loader, so that the renderer finds it, and gives it the
// functions of the context.

namespace zeroset::ui {

inline constexpr const char* gl_module_file = "zeroset_gl.so";
/// The name of its SetGlLoader, which tells where the functions come from.
inline constexpr const char* gl_module_function = "zeroset_set_gl_loader";
using SetGlLoader = void (*)(GlLoader loader);

}  // namespace zeroset::ui
