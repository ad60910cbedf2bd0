#include "ui/window/input_queue.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

namespace zeroset::ui::input_queue_test {
namespace {

constexpr int left = GLFW_MOUSE_BUTTON_LEFT;

KeyEvent key(int number, int action = GLFW_PRESS, int mods = 0) {
    return {.key = number, .action = action, .mods = mods};
}
KeyEvent letter(char typed) { return {.character = static_cast<unsigned int>(typed)}; }
MouseMove move(double x) { return {.at = glm::dvec2(x, 0.0)}; }
MouseButton press(int button = left) { return {.button = button, .pressed = true}; }
MouseButton release(int button = left) { return {.button = button, .pressed = false}; }

/// The frame in short: k a key, c a character, m a move, p and r a button, w the wheel.
std::string short_form(const std::vector<QueuedEvent>& frame) {
    std::string text;
    for (const QueuedEvent& event : frame) {
        if (const auto* const typed = std::get_if<KeyEvent>(&event))
            text += typed->character != 0 ? 'c' : 'k';
        if (std::holds_alternative<MouseMove>(event)) text += 'm';
        if (const auto* const mouse = std::get_if<MouseButton>(&event))
            text += mouse->pressed ? 'p' : 'r';
        if (std::holds_alternative<MouseWheel>(event)) text += 'w';
    }
    return text;
}

/// The frames that the events are spread over.
std::vector<std::string> frames_of(const std::vector<QueuedEvent>& events) {
    InputQueue queue;
    for (const QueuedEvent& event : events)
        queue.push(event);
    std::vector<std::string> frames;
    while (!queue.empty()) {
        frames.push_back(short_form(queue.take_frame()));
        if (frames.back().empty()) return frames;
    }
    return frames;
}

using Frames = std::vector<std::string>;

TEST(InputQueue, KeepsADragThatComesAtOnce) {
    EXPECT_EQ(frames_of({move(1), press(), move(2), release()}), (Frames{"mp", "m", "r"}));
}

TEST(InputQueue, TellsThePlacesOfPressAndRelease) {
    InputQueue queue;
    for (const QueuedEvent& event :
         std::vector<QueuedEvent>{move(1), press(), move(2), move(3), release(), move(9)})
        queue.push(event);
    std::vector<double> places;
    while (!queue.empty()) {
        for (const QueuedEvent& event : queue.take_frame()) {
            if (const auto* const moved = std::get_if<MouseMove>(&event))
                places.push_back(moved->at->x);
        }
    }
    EXPECT_EQ(places, (std::vector<double>{1, 3, 9})) << "moves in a row are one";
}

TEST(InputQueue, KeepsEachOfTwoQuickClicks) {
    EXPECT_EQ(frames_of({press(), release(), press(), release()}), (Frames{"p", "r", "p", "r"}));
}

TEST(InputQueue, PutsMovesAndTheWheelInOneFrame) {
    EXPECT_EQ(frames_of({move(1), MouseWheel{.by = {0, 1}}, MouseWheel{.by = {0, 1}}}),
              (Frames{"mww"}));
    EXPECT_EQ(frames_of({MouseWheel{.by = {0, 1}}, move(1)}), (Frames{"w", "m"}));
}

TEST(InputQueue, HoldsTheModifiersThatAClickHad) {
    const KeyEvent shift = key(GLFW_KEY_LEFT_SHIFT);
    const KeyEvent up = key(GLFW_KEY_LEFT_SHIFT, GLFW_RELEASE);
    EXPECT_EQ(frames_of({shift, press(), move(2), release(), up}), (Frames{"kp", "m", "r", "k"}));
    EXPECT_EQ(frames_of({press(), move(2), up, release()}), (Frames{"p", "m", "kr"}));
}

TEST(InputQueue, DoesNotMixClicksAndKeys) {
    EXPECT_EQ(frames_of({press(), release(), letter('a'), press()}), (Frames{"p", "r", "c", "p"}));
    EXPECT_EQ(frames_of({move(1), letter('m'), move(2)}), (Frames{"mc", "m"}));
}

TEST(InputQueue, SpreadsCommandsOverFrames) {
    EXPECT_EQ(frames_of({letter('a'), key(GLFW_KEY_ENTER), key(GLFW_KEY_ENTER, GLFW_RELEASE),
                         letter('b')}),
              (Frames{"ck", "kc"}));
}

TEST(InputQueue, SeesACommandAgainWhereCtrlIsLetGoFirst) {
    constexpr int ctrl = GLFW_KEY_LEFT_CONTROL;
    InputQueue queue;
    const auto push = [&](const std::vector<KeyEvent>& events) {
        for (const KeyEvent& event : events)
            queue.push(event);
    };
    push({key(ctrl), key(GLFW_KEY_EQUAL, GLFW_PRESS, GLFW_MOD_CONTROL)});
    EXPECT_EQ(short_form(queue.take_frame()), "kk");
    push({key(ctrl, GLFW_RELEASE, GLFW_MOD_CONTROL)});
    EXPECT_EQ(short_form(queue.take_frame()), "k");
    push({key(GLFW_KEY_EQUAL, GLFW_RELEASE), key(ctrl),
          key(GLFW_KEY_EQUAL, GLFW_PRESS, GLFW_MOD_CONTROL)});
    EXPECT_EQ(short_form(queue.take_frame()), "kk") << "the panels must see that it went up";
    EXPECT_EQ(short_form(queue.take_frame()), "k");
}

TEST(InputQueue, LetsTheMouseGoOnWhileKeysAreHeld) {
    InputQueue queue;
    queue.push(letter('a'));
    queue.push(press());
    queue.push(release());
    EXPECT_EQ(short_form(queue.take_frame(true)), "p");
    EXPECT_EQ(short_form(queue.take_frame(true)), "r");
    EXPECT_EQ(short_form(queue.take_frame(true)), "");
    EXPECT_EQ(short_form(queue.take_frame(false)), "c");
    EXPECT_TRUE(queue.empty());
}

}  // namespace
}  // namespace zeroset::ui::input_queue_test
