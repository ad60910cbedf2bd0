#pragma once

#include <glm/ext/vector_double2.hpp>

#include <deque>
#include <optional>
#include <variant>
#include <vector>

namespace zeroset::ui {

/// A key transition or a typed character; numbers as in GLFW.
struct KeyEvent {
    int key = 0;  ///< unused for a character
    int scancode = 0;
    int action = 0;
    int mods = 0;
    unsigned int character = 0;  ///< code point of a character; 0: a key transition
};

/// The pointer came to a place, in window coordinates; nothing: it came or went, and its place has
/// to be asked for.
struct MouseMove {
    std::optional<glm::dvec2> at;
};

struct MouseButton {
    int button = 0;  ///< as in GLFW
    bool pressed = false;
};

/// Offsets of a wheel or a touchpad, in notches.
struct MouseWheel {
    glm::dvec2 by{0.0};
};

using QueuedEvent = std::variant<KeyEvent, MouseMove, MouseButton, MouseWheel>;

/// Spreads the events of keyboard and mouse over frames. The panels see both once per frame, as a
/// state; without the queue a key or a button pressed and released between two frames, two commands
/// in one frame or a drag that a slow frame sees at once would be lost.
class InputQueue {
public:
    void push(const QueuedEvent& event);
    [[nodiscard]] bool empty() const { return events_.empty(); }
    /// Removes and returns the longest prefix of events that one frame can process without loss.
    /// With `holds_keys`, keys stay where they are and the mouse goes on.
    std::vector<QueuedEvent> take_frame(bool holds_keys = false);

private:
    std::deque<QueuedEvent> events_;
    unsigned held_ = 0;  ///< the buttons that are down, as bits
};

}  // namespace zeroset::ui
