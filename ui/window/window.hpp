#pragma once

#include "ui/model/theme.hpp"

#include <chrono>
#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset::ui {

/// Size of the smallest window that the panels fit into, at scale 1.
inline constexpr int min_width = 480;
inline constexpr int min_height = 320;
/// Number of frames after a change: ImGui lays out with the sizes of the previous frame, so that a
/// change takes up to three frames to settle.
inline constexpr int frames_to_settle = 3;

/// An action of the user and the time at which it reached the program.
struct InputEvent {
    enum class Kind : std::uint8_t { Move, Button, Wheel, Key };
    Kind kind = Kind::Move;
    std::chrono::steady_clock::time_point at;
};

/// Events from outside the panels since the last take_events().
struct WindowEvents {
    std::optional<InputEvent> input;   ///< the first input since then
    bool close = false;                ///< the user asked to close the window
    std::vector<std::string> dropped;  ///< paths of files dropped on the window
    /// By how much two fingers that pinch a touchpad have moved apart: a factor; 1: not at all.
    double pinch = 1.0;
};

/// Size of a window at scale 1.
struct WindowSize {
    int width = 1280;
    int height = 800;
    bool maximized = false;  ///< if so, width and height are those of the restored window
    bool operator==(const WindowSize&) const = default;
};

/// A surface with an OpenGL context that the panels are drawn on, frame by frame. All members
/// belong to the thread that created it, except wake(). The backends share GuiContext and differ in
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
    /// Ends the wait() in progress, or else the next one. Any thread.
    virtual void wake() = 0;

    /// The panels may be drawn between begin_frame() and end_frame().
    virtual void begin_frame(Theme theme) = 0;
    virtual void end_frame() = 0;
    /// True once the graphics driver has lost the context: nothing can be drawn any more.
    [[nodiscard]] virtual bool is_lost() const = 0;

    virtual WindowEvents take_events() = 0;
    /// Holds keys back for a later frame: wanted while a field is about to get the keyboard but
    /// does not have it yet.
    virtual void hold_keys(bool hold) = 0;
    [[nodiscard]] virtual WindowSize size() const = 0;
    /// Name by which a desktop portal knows the window, "x11:" and its id in hexadecimal digits;
    /// empty if the window has no such name that is easily available.
    [[nodiscard]] virtual std::string portal_name() const = 0;
    /// Sets the size of letters and of all that is measured by them, from the next frame on, as a
    /// part of the usual size; it is less where the panels would not fit into the window.
    virtual void set_letters(float size) = 0;
    /// Fills the screen, or has borders again; returns which of them it is.
    virtual bool set_full_screen(bool on) = 0;
    /// Sets the title (UTF-8).
    virtual void set_title(const std::string& title) = 0;
};

struct WindowOptions {
    std::string title = "Zeroset";
    WindowSize size;  ///< smaller if the screen is
};

/// Creates a window on the desktop, or returns one line that says what is missing (a display,
/// OpenGL 3.3). The environment variable ZEROSET_SCALE (1 to 4) overrides the screen's content
/// scale.
std::expected<std::unique_ptr<Window>, std::string> make_glfw_window(const WindowOptions& options);

}  // namespace zeroset::ui
