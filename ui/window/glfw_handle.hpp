#pragma once

#include "ui/window/window.hpp"

#include <GLFW/glfw3.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace zeroset::ui {

inline constexpr float max_scale = 4.0F;

/// The scale that ZEROSET_SCALE says; nothing: the screen's scale counts.
std::optional<float> scale_override();

/// GLFW's description of its last error.
std::string glfw_reason();

/// Calls glfwInit and, at the end of its life, glfwTerminate.
class GlfwLibrary {
public:
    GlfwLibrary() : ready_(glfwInit() == GLFW_TRUE) {}
    ~GlfwLibrary() {
        if (ready_) glfwTerminate();
    }
    GlfwLibrary(const GlfwLibrary&) = delete;
    GlfwLibrary& operator=(const GlfwLibrary&) = delete;
    explicit operator bool() const { return ready_; }

private:
    bool ready_;
};

struct DestroyWindow {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using WindowHandle = std::unique_ptr<GLFWwindow, DestroyWindow>;

/// A window with an OpenGL context of version 3.3; nullptr: glfw_reason() says why there is none.
WindowHandle open_window(const WindowOptions& options);

/// The window's X11 id; 0: it is none of X11.
std::uint32_t x11_window(GLFWwindow* window);

}  // namespace zeroset::ui
