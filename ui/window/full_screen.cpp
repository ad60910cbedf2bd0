#include "ui/window/full_screen.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace zeroset::ui {

FullScreen::Bounds FullScreen::bounds_of(GLFWwindow* window) {
    Bounds bounds;
    glfwGetWindowPos(window, &bounds.left, &bounds.top);
    glfwGetWindowSize(window, &bounds.width, &bounds.height);
    return bounds;
}

void FullScreen::enter(GLFWwindow* window) {
    const Bounds bounds = bounds_of(window);
    int count = 0;
    GLFWmonitor** const all = glfwGetMonitors(&count);
    GLFWmonitor* best = glfwGetPrimaryMonitor();
    int most = 0;
    for (GLFWmonitor* const one : std::span(all, static_cast<std::size_t>(count))) {
        const GLFWvidmode* const mode = glfwGetVideoMode(one);
        if (mode == nullptr) continue;
        int left = 0;
        int top = 0;
        glfwGetMonitorPos(one, &left, &top);
        const int wide =
            std::min(bounds.left + bounds.width, left + mode->width) - std::max(bounds.left, left);
        const int high =
            std::min(bounds.top + bounds.height, top + mode->height) - std::max(bounds.top, top);
        const int area = std::max(wide, 0) * std::max(high, 0);
        if (area > most) best = one;
        most = std::max(most, area);
    }
    const GLFWvidmode* const mode = best == nullptr ? nullptr : glfwGetVideoMode(best);
    if (mode == nullptr) return;
    bordered_ = bounds;
    on_ = true;
    glfwSetWindowMonitor(window, best, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void FullScreen::leave(GLFWwindow* window) {
    on_ = false;
    glfwSetWindowMonitor(window, nullptr, bordered_.left, bordered_.top, bordered_.width,
                         bordered_.height, GLFW_DONT_CARE);
}

}  // namespace zeroset::ui
