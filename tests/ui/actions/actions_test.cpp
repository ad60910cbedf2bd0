// Tests of the table of actions and its keys.

#include "ui/actions/actions.hpp"

#include "ui/widgets/chord.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace zeroset::ui::actions_test {
namespace {

TEST(Chord, IsReadAsItIsWritten) {
    EXPECT_EQ(chord_of("Ctrl+Shift+Z"), (Chord{.ctrl = true, .shift = true, .key = GLFW_KEY_Z}));
    EXPECT_EQ(chord_of("Alt+Up"), (Chord{.alt = true, .key = GLFW_KEY_UP}));
    EXPECT_EQ(chord_of("F11"), Chord{.key = GLFW_KEY_F11});
    EXPECT_EQ(chord_of("R"), Chord{.letter = 'r'});
    EXPECT_EQ(chord_of("Shift+R"), (Chord{.shift = true, .letter = 'r'}));
    EXPECT_EQ(chord_of("+"), Chord{.letter = '+'});
    EXPECT_EQ(chord_of("Ctrl++"), (Chord{.ctrl = true, .key = '+'}));
    for (const char* wrong : {"", "Ctrl+", "F13", "F0", "F1x", "Hyper+A", "ctrl+a", "\n"}) {
        EXPECT_FALSE(chord_of(wrong)) << wrong;
    }
}

TEST(Chord, ListsHaveTheirOrder) {
    const std::vector<Chord> chords = chords_of("Home, Ctrl+Y, 7");
    ASSERT_EQ(chords.size(), 3U);
    EXPECT_EQ(chords[0].key, GLFW_KEY_HOME);
    EXPECT_EQ(chords[1].key, GLFW_KEY_Y);
    EXPECT_EQ(chords[2].letter, '7');
}

TEST(Actions, HaveNamesAndKeysOfTheirOwn) {
    std::set<std::string> names;
    std::vector<Chord> taken;
    for (const Action& action : actions()) {
        EXPECT_TRUE(names.insert(action.name).second) << action.name;
        EXPECT_NE(action.run, nullptr) << action.name;
        const std::string keys = action.keys;
        const auto chords = chords_of(keys);
        const auto commas = static_cast<std::size_t>(std::ranges::count(keys, ','));
        EXPECT_EQ(chords.size(), keys.empty() ? 0U : commas + 1U) << keys;
        for (const Chord& chord : chords) {
            EXPECT_EQ(std::ranges::count(taken, chord), 0) << keys << " has another meaning";
            taken.push_back(chord);
        }
    }
}

TEST(Actions, OfASwitchTurnItOnAndOff) {
    for (const Action& action : actions()) {
        if (action.is_on == nullptr || action.chooses) continue;
        UiState state;
        state.shown.tracers = {{.name = "beams", .about = "", .finds_jumps = true},
                               {.name = "newton", .about = "", .finds_jumps = false}};
        const bool before = action.is_on(state);
        action.run(state);
        EXPECT_NE(action.is_on(state), before) << action.name;
        action.run(state);
        EXPECT_EQ(action.is_on(state), before) << action.name;
    }
}

TEST(Actions, OfAChoiceTakeItInPlaceOfTheOthers) {
    constexpr int choices = 5;  // colours, looks, contour lines, the wheel, languages
    UiState state;
    for (const Action& action : actions()) {
        if (!action.chooses) continue;
        action.run(state);
        EXPECT_TRUE(action.is_on(state)) << action.name;
        const auto taken = [&](const Action& one) { return one.chooses && one.is_on(state); };
        EXPECT_EQ(std::ranges::count_if(actions(), taken), choices) << action.name;
    }
}

TEST(Actions, OfAxesSayWhatNewDocumentsBeginWith) {
    UiState state;
    state.edited.document = new_document(state.edited.layout);
    const Document& document = state.edited.document;
    EXPECT_TRUE(document.axes && document.clip_box && document.grid) << "at first";
    const Action& all = action_named("Axes, box and grid");
    EXPECT_TRUE(all.is_on(state));
    action_named("Grid").run(state);
    EXPECT_FALSE(document.grid || all.is_on(state));
    EXPECT_FALSE(new_document(state.edited.layout).grid);
    EXPECT_TRUE(new_document(state.edited.layout).axes);
    all.run(state);
    EXPECT_TRUE(document.axes && document.clip_box && document.grid);
    all.run(state);
    EXPECT_FALSE(document.axes || document.clip_box || document.grid);
    EXPECT_EQ(new_document(state.edited.layout), empty_document());
}

TEST(Actions, OfEdgesSayWhetherThoseOfNewDocumentsAreSmooth) {
    UiState state;
    EXPECT_EQ(new_document(state.edited.layout).antialias, Antialias::Beams);
    const Action& smooth = action_named("Smooth edges");
    EXPECT_TRUE(smooth.is_on(state));
    smooth.run(state);
    EXPECT_EQ(state.edited.document.antialias, Antialias::None);
    EXPECT_EQ(new_document(state.edited.layout).antialias, Antialias::None);
    smooth.run(state);
    EXPECT_EQ(new_document(state.edited.layout).antialias, Antialias::Beams);
}

TEST(Actions, AreDescribedWithTheirFirstKeys) {
    EXPECT_EQ(described(action_named("Redo")), "Redo (Ctrl+Shift+Z)");
    EXPECT_EQ(described(action_named("Light theme")), "Light theme");
}

TEST(Actions, HaveTheirKeysOnTheWindowsPage) {
    std::ifstream file(ZEROSET_SOURCE_DIR "/resources/docs/window.md");
    const std::string page(std::istreambuf_iterator<char>(file), {});
    const std::string table = page.substr(page.find("| key, mouse |"));
    for (const Action& action : actions()) {
        const std::string keys = shown_keys(action);
        EXPECT_TRUE(keys.empty() || table.contains(keys)) << keys;
    }
}

}  // namespace
}  // namespace zeroset::ui::actions_test
