#pragma once

#include <GLFW/glfw3.h>

namespace zeroset::ui {

/// Every Window numbers the keys as GLFW does; Dear ImGui has no name of its own for this one.
inline constexpr int key_f1 = GLFW_KEY_F1;

}  // namespace zeroset::ui
