#include "ui/window/key_queue.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr int command_mods = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;

bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

/// True for both Shift keys. Shift has already acted on characters when they arrive; it matters to
/// commands only.
bool is_shift(int key) { return key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT; }

/// True for a key that acts by itself (arrows, Enter, Escape) or together with Ctrl, Alt or Super.
bool is_command(const KeyEvent& event) {
    if (is_modifier(event.key)) return false;
    return event.key >= GLFW_KEY_ESCAPE || (event.mods & command_mods) != 0;
}

/// The events of one frame so far. In a frame, a text field first takes the characters, then at
/// most one command under the modifiers held at the end of the frame; that command may move the
/// keyboard elsewhere. Escape leaves the field before it takes any characters.
class FrameEvents {
public:
    [[nodiscard]] bool fits(const KeyEvent& event) const {
        if (event.character != 0) return !command_;
        if (event.action == GLFW_REPEAT) return true;
        if (event.key == GLFW_KEY_ESCAPE && text_) return false;
        if (is_shift(event.key)) return !command_;
        if (is_modifier(event.key)) return !command_ && !text_ && !touched(event.key);
        if (event.action == GLFW_PRESS && command_) return false;
        return !touched(event.key);
    }

    void add(const KeyEvent& event) {
        if (event.character != 0) {
            text_ = true;
        } else if (event.action != GLFW_REPEAT && !is_shift(event.key) &&
                   (is_modifier(event.key) || is_command(event))) {
            command_ = command_ || (event.action == GLFW_PRESS && is_command(event));
            keys_.push_back(event.key);
        }
    }

private:
    [[nodiscard]] bool touched(int key) const {
        return std::ranges::find(keys_, key) != keys_.end();
    }

    bool text_ = false;
    bool command_ = false;
    std::vector<int> keys_;
};

}  // namespace

std::vector<KeyEvent> KeyQueue::take_frame() {
    std::vector<KeyEvent> taken;
    FrameEvents frame;
    while (!events_.empty() && frame.fits(events_.front())) {
        frame.add(events_.front());
        taken.push_back(events_.front());
        events_.pop_front();
    }
    return taken;
}

}  // namespace zeroset::ui
