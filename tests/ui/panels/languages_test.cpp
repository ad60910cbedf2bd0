// Tests of the window in other languages: that texts, keys and numbers are theirs, and what is
// found by typing.

#include "engine/base/translation.hpp"
#include "tests/ui/panels.hpp"
#include "ui/actions/actions.hpp"
#include "ui/pages/command_palette.hpp"
#include "ui/panels/sections.hpp"
#include "ui/widgets/chord.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace zeroset::ui::languages_test {
namespace {

class Languages : public Panels {
protected:
    ~Languages() override { set_language(Language::English); }

    /// The palette's first answer to what is typed.
    std::string found_by(const std::string& typed) {
        const auto lines = palette_lines(state_, typed);
        return lines.empty() ? "" : lines.front().text;
    }
};

TEST_P(Languages, NameActionsAndTheirKeys) {
    set_language(Language::German, ',');
    EXPECT_EQ(described(action_named("Save")), "Speichern (Strg+S)");
    EXPECT_EQ(keys_in_language("Shift+Delete, F1, R"), "Umschalt+Entf, F1, R");
    set_language(Language::French, ',');
    EXPECT_EQ(keys_in_language("Ctrl+Shift+Z"), "Ctrl+Maj+Z");
    set_language(Language::English);
    EXPECT_EQ(keys_in_language("Ctrl+Shift+Z, Ctrl++"), "Ctrl+Shift+Z, Ctrl++");
}

TEST_P(Languages, FindCommandsByTheirOwnWordsAndByEnglishOnes) {
    set_language(Language::German, ',');
    EXPECT_EQ(found_by("speichern unter"), tr("Save as..."));
    EXPECT_EQ(found_by("vollbild"), tr("Full screen"));
    EXPECT_EQ(found_by("full screen"), tr("Full screen"));
    set_language(Language::Spanish, ',');
    EXPECT_EQ(found_by("guardar como"), tr("Save as..."));
    set_language(Language::English);
    EXPECT_EQ(found_by("deutsch"), "Language: German");
}

TEST_P(Languages, WriteNumbersOfSlidersAndFieldsWithTheirMark) {
    PictureFigures figures;
    figures.frame_ms = 5.25;
    EXPECT_EQ(frame_time(figures.frame_ms), "5.2 ms");
    set_language(Language::German, ',');
    EXPECT_EQ(frame_time(figures.frame_ms), "5,2 ms");
}

TEST_P(Languages, ChangeWhatTheWindowShows) {
    state_.edited.layout.view_open = true;
    draw();
    const Framebuffer english = draw();
    set_language(Language::German, ',');
    const Framebuffer german = draw();
    EXPECT_NE(english.color, german.color);
    set_language(Language::English);
    EXPECT_EQ(english.color, draw().color);
}

TEST_P(Languages, AreChosenByActions) {
    action_named("Language: French").run(state_);
    EXPECT_EQ(state_.edited.layout.language, Language::French);
    action_named("Language of the desktop").run(state_);
    EXPECT_EQ(state_.edited.layout.language, std::nullopt);
}

TEST_P(Languages, TellActionsApart) {
    for (const Language language : all_languages) {
        set_language(language);
        std::vector<std::string> names;
        for (const Action& action : actions())
            names.emplace_back(tr(action.name));
        std::ranges::sort(names);
        const auto twice = std::ranges::adjacent_find(names);
        EXPECT_EQ(twice, names.end()) << name_of(language);
        if (twice != names.end()) ADD_FAILURE() << *twice;
    }
}

INSTANTIATE_TEST_SUITE_P(Looks, Languages, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::languages_test
