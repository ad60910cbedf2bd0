#include "ui/window/input_queue.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr int command_mods = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;

bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

/// True for both Shift keys. Shift has already acted on characters when they arrive; it matters to
/// commands and to the mouse only.
bool is_shift(int key) { return key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT; }

/// True for a key that acts by itself (arrows, Enter, Escape) or together with Ctrl, Alt or Super.
bool is_command(const KeyEvent& event) {
    if (is_modifier(event.key)) return false;
    return event.key >= GLFW_KEY_ESCAPE || (event.mods & command_mods) != 0;
}

/// The events of one frame so far. In a frame, a text field first takes the characters, then at
/// most one command under the modifiers held at the end of the frame; that command may move the
/// keyboard elsewhere. Escape leaves the field before it takes any characters. The pointer is where
/// it is at the end of the frame, and only then a button goes down or up: what was dragged until
/// its release needs a frame of its own.
class FrameEvents {
public:
    /// `held`: the buttons that are down before the frame, as bits.
    explicit FrameEvents(unsigned held) : drags_(held != 0) {}

    [[nodiscard]] bool fits(const KeyEvent& event) const {
        if (button_) return false;
        if (event.character != 0) return !command_;
        if (event.action == GLFW_REPEAT) return true;
        if (event.key == GLFW_KEY_ESCAPE && text_) return false;
        if (is_modifier(event.key) && (wheel_ || (moved_ && drags_))) return false;
        if (is_shift(event.key)) return !command_;
        if (is_modifier(event.key)) return !command_ && !text_ && !is_in(keys_, event.key);
        if (event.action == GLFW_PRESS && command_) return false;
        // Ctrl may be let go before the key, whose release is no command then.
        if (event.action == GLFW_PRESS && is_command(event) && is_in(released_, event.key))
            return false;
        return !is_in(keys_, event.key);
    }
    [[nodiscard]] bool fits(const MouseMove&) const {
        return !button_ && !wheel_ && !text_ && !command_;
    }
    [[nodiscard]] bool fits(const MouseButton&) const {
        return !button_ && !wheel_ && !text_ && !command_ && !(moved_ && drags_);
    }
    [[nodiscard]] bool fits(const MouseWheel&) const { return !button_ && !text_ && !command_; }

    void add(const KeyEvent& event) {
        if (event.character == 0 && event.action == GLFW_RELEASE) released_.push_back(event.key);
        if (event.character != 0) {
            text_ = true;
        } else if (event.action != GLFW_REPEAT && !is_shift(event.key) &&
                   (is_modifier(event.key) || is_command(event))) {
            command_ = command_ || (event.action == GLFW_PRESS && is_command(event));
            keys_.push_back(event.key);
        }
    }
    void add(const MouseMove&) { moved_ = true; }
    void add(const MouseButton&) { button_ = true; }
    void add(const MouseWheel&) { wheel_ = true; }

private:
    static bool is_in(const std::vector<int>& keys, int key) {
        return std::ranges::find(keys, key) != keys.end();
    }

    bool drags_;
    bool text_ = false;
    bool command_ = false;
    bool moved_ = false;
    bool button_ = false;
    bool wheel_ = false;
    std::vector<int> keys_;      ///< modifiers and commands that went down or up
    std::vector<int> released_;  ///< all keys that went up
};

}  // namespace

void InputQueue::push(const QueuedEvent& event) {
    const bool moves = !events_.empty() && std::holds_alternative<MouseMove>(events_.back()) &&
                       std::holds_alternative<MouseMove>(event);
    if (moves) {
        events_.back() = event;
    } else {
        events_.push_back(event);
    }
}

std::vector<QueuedEvent> InputQueue::take_frame(bool holds_keys) {
    std::vector<QueuedEvent> taken;
    FrameEvents frame(held_);
    std::size_t at = 0;
    while (at < events_.size()) {
        const QueuedEvent event = events_[at];
        if (holds_keys && std::holds_alternative<KeyEvent>(event)) {
            ++at;
            continue;
        }
        if (!std::visit([&frame](const auto& it) { return frame.fits(it); }, event)) break;
        std::visit([&frame](const auto& it) { frame.add(it); }, event);
        if (const auto* const mouse = std::get_if<MouseButton>(&event)) {
            const unsigned bit = 1U << static_cast<unsigned>(mouse->button);
            held_ = mouse->pressed ? held_ | bit : held_ & ~bit;
        }
        taken.push_back(event);
        events_.erase(events_.begin() + static_cast<std::ptrdiff_t>(at));
    }
    return taken;
}

}  // namespace zeroset::ui
