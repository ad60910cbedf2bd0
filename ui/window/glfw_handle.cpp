#include "ui/window/glfw_handle.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace zeroset::ui {
namespace {

/// The requested size, limited to the work area of the primary monitor.
std::pair<int, int> fitting_size(const WindowOptions& options) {
    const float scale = scale_override().value_or(1.0F);
    int width = static_cast<int>(static_cast<float>(options.size.width) * scale);
    int height = static_cast<int>(static_cast<float>(options.size.height) * scale);
    if (GLFWmonitor* screen = glfwGetPrimaryMonitor(); screen != nullptr) {
        int left = 0;
        int top = 0;
        int free_width = 0;
        int free_height = 0;
        glfwGetMonitorWorkarea(screen, &left, &top, &free_width, &free_height);
        if (free_width > 0) width = std::min(width, free_width);
        if (free_height > 0) height = std::min(height, free_height);
    }
    return {width, height};
}

}  // namespace

std::optional<float> scale_override() {
    const char* text = std::getenv("ZEROSET_SCALE");
    if (text == nullptr) return std::nullopt;
    char* end = nullptr;
    const float scale = std::strtof(text, &end);
    if (end == text || !(scale >= 1.0F) || !(scale <= max_scale)) return std::nullopt;
    return scale;
}

std::string glfw_reason() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    return reason == nullptr ? "unknown reason" : reason;
}

WindowHandle open_window(const WindowOptions& options) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    // Lets the driver report a reset of the graphics card.
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, scale_override() ? GLFW_FALSE : GLFW_TRUE);
    // A full screen stays while another window, on another screen, has the keyboard.
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
    glfwWindowHint(GLFW_MAXIMIZED, options.size.maximized ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "zeroset");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "zeroset");
    const auto [width, height] = fitting_size(options);
    return WindowHandle(glfwCreateWindow(width, height, options.title.c_str(), nullptr, nullptr));
}

std::uint32_t x11_window(GLFWwindow* window) {
    // GLFW built for Wayland only lacks this function.
    using GetX11Window = unsigned long (*)(GLFWwindow*);
    const auto get = reinterpret_cast<GetX11Window>(dlsym(RTLD_DEFAULT, "glfwGetX11Window"));
    return get == nullptr ? 0 : static_cast<std::uint32_t>(get(window));
}

}  // namespace zeroset::ui
