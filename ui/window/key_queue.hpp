#pragma once

#include <deque>
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

/// Spreads key events over frames. The panels see the keyboard once per frame, as a state; without
/// the queue a key pressed and released between two frames, or two commands in one frame, would be
/// lost.
class KeyQueue {
public:
    void push(const KeyEvent& event) { events_.push_back(event); }
    [[nodiscard]] bool empty() const { return events_.empty(); }
    /// Removes and returns the longest prefix of events that one frame can process without loss.
    std::vector<KeyEvent> take_frame();

private:
    std::deque<KeyEvent> events_;
};

}  // namespace zeroset::ui
