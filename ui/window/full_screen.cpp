#include "ui/window/full_screen.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace zeroset::ui {

FullScreen::Place FullScreen::place_of(GLFWwindow* window) {
    Place place;
    glfwGetWindowPos(window, &place.left, &place.top);
    glfwGetWindowSize(window, &place.width, &place.height);
    return place;
}

void FullScreen::enter(GLFWwindow* window) {
    const Place place = place_of(window);
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
            std::min(place.left + place.width, left + mode->width) - std::max(place.left, left);
        const int high =
            std::min(place.top + place.height, top + mode->height) - std::max(place.top, top);
        const int area = std::max(wide, 0) * std::max(high, 0);
        if (area > most) best = one;
        most = std::max(most, area);
    }
    const GLFWvidmode* const mode = best == nullptr ? nullptr : glfwGetVideoMode(best);
    if (mode == nullptr) return;
    bordered_ = place;
    on_ = true;
    glfwSetWindowMonitor(window, best, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void FullScreen::leave(GLFWwindow* window) {
    on_ = false;
    glfwSetWindowMonitor(window, nullptr, bordered_.left, bordered_.top, bordered_.width,
                         bordered_.height, GLFW_DONT_CARE);
}

}  // namespace zeroset::ui
