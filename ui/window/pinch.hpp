#pragma once

#include <cstdint>
#include <functional>
#include <memory>

namespace zeroset::ui {

/// An event of a pinch, as X11's XInput 2.4 has it.
struct PinchEvent {
    bool begins = false;
    /// How far the fingers are apart, as a part of how far they were at the beginning: 16.16 fixed
    /// point.
    std::int32_t spread = 0;
};

/// Follows one pinch after the other.
class PinchSteps {
public:
    /// How far the fingers are apart, as a part of how far they were at the event before.
    double follow(const PinchEvent& event);

private:
    double last_ = 1.0;
};

/// Pinches on a touchpad over an X11 window, of which GLFW tells nothing: a connection and a thread
/// of its own. Where the display has no touchpad that tells of them nothing ever comes.
class PinchListener {
public:
    /// `window`: its X11 id. `wake` is called from another thread when fingers have moved.
    PinchListener(std::uint32_t window, std::function<void()> wake);
    ~PinchListener();
    PinchListener(const PinchListener&) = delete;
    PinchListener& operator=(const PinchListener&) = delete;

    /// False where the display is older than XInput 2.4.
    [[nodiscard]] bool listens() const;
    /// How far the fingers are apart, as a part of how far they were at the last call. Any thread.
    double take();

private:
    class Connection;
    std::unique_ptr<Connection> connection_;
};

}  // namespace zeroset::ui
