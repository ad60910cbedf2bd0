#pragma once

struct GLFWwindow;

namespace zeroset::ui {

/// Lets a window fill the screen that shows most of it, and gives it its bounds back. The window's
/// thread only.
class FullScreen {
public:
    [[nodiscard]] bool is_on() const { return on_; }
    /// Fills the screen; nothing happens where there is none.
    void enter(GLFWwindow* window);
    /// Gives the window its borders again, where it was.
    void leave(GLFWwindow* window);

private:
    /// A window's bounds on the desktop, in its coordinates.
    struct Bounds {
        int left = 0, top = 0, width = 0, height = 0;
    };
    static Bounds bounds_of(GLFWwindow* window);

    bool on_ = false;
    Bounds bordered_;  ///< where the window goes when it leaves the full screen
};

}  // namespace zeroset::ui
