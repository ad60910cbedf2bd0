#pragma once

#include "ui/model/ui_state.hpp"

#include <chrono>
#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset::ui {

/// The smallest window that the panels fit into, at scale 1.
inline constexpr int min_width = 480;
inline constexpr int min_height = 320;
/// ImGui lays out with the sizes of the frame before, so that a change takes up to three frames.
inline constexpr int frames_to_settle = 3;

/// Something that the user did, when it arrived in the program.
struct InputEvent {
    enum class Kind : std::uint8_t { Move, Button, Wheel, Key };
    Kind kind = Kind::Move;
    std::chrono::steady_clock::time_point at;
};

/// What came from outside the panels since it was last taken.
struct WindowEvents {
    std::optional<InputEvent> input;   ///< the first
    bool close = false;                ///< the window is to be closed
    std::vector<std::string> dropped;  ///< paths of files dropped on it
};

/// Of a window, at scale 1.
struct WindowSize {
    int width = 1280;
    int height = 800;
    bool maximized = false;  ///< then this is its size when it is so no more
    bool operator==(const WindowSize&) const = default;
};

/// A surface with an OpenGL context that the panels are drawn on, frame by frame. All members
/// are for the thread that made it, except wake(). The backends share GuiContext and differ in
/// where the pixels go and where the input comes from.
class Window {
public:
    Window() = default;
    virtual ~Window() = default;
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Sleeps until a frame is worth drawing: input, wake(), the blink of a text cursor, or the end
    /// of `at_most_s` seconds.
    virtual void wait(std::optional<double> at_most_s) = 0;
    /// Ends a wait() in progress or the next one. Any thread.
    virtual void wake() = 0;

    /// Between these two, the panels may be drawn.
    virtual void begin_frame(Theme theme) = 0;
    virtual void end_frame() = 0;
    /// Whether the graphics driver has given up the context: nothing can be drawn any more.
    [[nodiscard]] virtual bool is_lost() const = 0;

    virtual WindowEvents take_events() = 0;
    /// Whether keys are to wait for a later frame: while no field has the keyboard yet that is
    /// about to get it.
    virtual void hold_keys(bool hold) = 0;
    [[nodiscard]] virtual WindowSize size() const = 0;
    /// By which name a desktop's portal knows the window, "x11:" and its id in hexadecimal digits;
    /// empty where it has none that can simply be had.
    [[nodiscard]] virtual std::string portal_name() const = 0;
    /// UTF-8.
    virtual void set_title(const std::string& title) = 0;
};

struct WindowOptions {
    std::string title = "Zeroset";
    WindowSize size;  ///< less if the screen is smaller
};

/// A window on the desktop, or one line that says what is missing (a display, OpenGL 3.3).
/// The environment variable ZEROSET_SCALE (1 to 4) overrides the screen's content scale.
std::expected<std::unique_ptr<Window>, std::string> make_glfw_window(const WindowOptions& options);

}  // namespace zeroset::ui
