#pragma once

#include <deque>
#include <vector>

namespace zeroset::ui {

/// A key's transition or a typed character, in GLFW's numbers.
struct KeyEvent {
    int key = 0;  ///< unused for a character
    int scancode = 0;
    int action = 0;
    int mods = 0;
    unsigned int character = 0;  ///< a code point; 0: this is a key's transition
};

/// Spreads key events over frames. The panels see the keyboard once a frame, as a state, so that
/// a key pressed and released between two frames, or two commands in one frame, would be lost.
class KeyQueue {
public:
    void push(const KeyEvent& event) { events_.push_back(event); }
    [[nodiscard]] bool empty() const { return events_.empty(); }
    /// Removes the longest run of events, in order, that one frame can tell apart.
    std::vector<KeyEvent> take_frame();

private:
    std::deque<KeyEvent> events_;
};

}  // namespace zeroset::ui
