#pragma once

#include "engine/trace/camera.hpp"
#include "engine/trace/scene.hpp"

#include <optional>
#include <string>

namespace zeroset {

/// What the window starts with.
struct DesktopOptions {
    std::string equation;
    Box clip;
    double w = 0.0;
    std::optional<Camera> camera;  ///< looks at the whole clip box when absent
    TraceSettings settings;
};

/// Opens the window and runs until it is closed; returns the process's exit code. Without a display
/// or OpenGL it says so in one line on stderr and returns 1.
int run_desktop(const DesktopOptions& options);

}  // namespace zeroset
