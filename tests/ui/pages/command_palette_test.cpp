// Tests of the command palette: the entries that a typed text finds, and running them.

#include "ui/pages/command_palette.hpp"

#include "tests/ui/panels.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/text_match.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/window/offscreen_window.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace zeroset::ui::command_palette_test {
namespace {

TEST(TextMatch, FindsPartsWhateverTheCapitals) {
    EXPECT_TRUE(contains("Barth Sextic", "SEX"));
    EXPECT_TRUE(contains("x", ""));
    EXPECT_FALSE(contains("x", "xx"));
    EXPECT_TRUE(contains_words("Barth Sextic", "tic bar"));
    EXPECT_FALSE(contains_words("Barth Sextic", "bar tac"));
}

TEST(TextMatch, PrefersBeginningsAndNeighbours) {
    const auto score = [](const char* text, const char* typed) {
        return abbreviation_score(text, typed).value_or(-1000);
    };
    EXPECT_EQ(score("Save as...", "xz"), -1000);
    EXPECT_EQ(score("Save", "saves"), -1000);
    EXPECT_GT(score("Save as...", "sa"), score("Gyroid to Schwarz P", "sa"));
    EXPECT_GT(score("Reset the view", "rv"), score("Section: View", "rv"));
    EXPECT_GT(score("Save", "save"), score("Save as...", "save"));
    EXPECT_GT(score("Undo", "und"), score("Mark undecided pixels", "ud"));
    EXPECT_NE(score("Barth Sextic", "barth sextic"), -1000) << "spaces aside";
}

TEST(TextMatch, PrefersWholeWordsThenBeginnings) {
    const auto match = [](const char* text, const char* typed) { return match_of(text, typed); };
    EXPECT_EQ(match("Barth Sextic", "sextic barth")->closeness, Closeness::WholeWords);
    EXPECT_EQ(match("Barth Sextic", "bar sextic")->closeness, Closeness::Beginnings);
    EXPECT_EQ(match("Barth Sextic", "ext")->closeness, Closeness::Inside);
    EXPECT_EQ(match("Barth Sextic", "bsx")->closeness, Closeness::Scattered);
    EXPECT_EQ(match("\xC3\x9C"
                    "ber uns",
                    "uber")
                  ->closeness,
              Closeness::WholeWords);
    EXPECT_FALSE(match("Barth Sextic", "quintic"));
    EXPECT_GT(match("Light theme", "light"), match("Delight", "light"));
    EXPECT_GT(match("A cut", "cut"), match("Cutaway", "cut")) << "a whole word, later and longer";
}

UiState some_state() {
    UiState state;
    state.shown.gallery = {{"Torus", "x = 1", "A ring.", "Algebraic", "Anna"},
                           {"Undulation", "y = 1", "A wave.", "Periodic", "Berta"}};
    state.shown.document.recent = {"/some/where/unduloid.zeroset.json"};
    state.shown.document.can_undo = true;
    return state;
}

std::vector<std::string> texts(const std::vector<PaletteLine>& lines) {
    std::vector<std::string> found;
    for (const PaletteLine& line : lines)
        found.push_back(line.text);
    return found;
}

TEST(PaletteLines, AreActionsSurfacesAndRecentFiles) {
    const auto lines = palette_lines(some_state(), "");
    EXPECT_EQ(lines.size(), actions().size() - 1 + 2 + 1) << "all but the palette itself";
    const auto found = texts(palette_lines(some_state(), "und"));
    ASSERT_GE(found.size(), 4U);
    EXPECT_EQ(found[0], "Undo");
    EXPECT_EQ(found[1], "Undulation") << "the shorter first";
    EXPECT_EQ(found[2], "Mark undecided pixels");
    EXPECT_EQ(found[3], "unduloid.zeroset.json");
}

TEST(PaletteLines, LeaveTheDocumentWhereLettersAreScattered) {
    const auto found = texts(palette_lines(some_state(), "udi"));
    EXPECT_EQ(std::ranges::count(found, "Undulation"), 0);
    EXPECT_EQ(std::ranges::count(found, "unduloid.zeroset.json"), 0);
    EXPECT_EQ(std::ranges::count(found, "Mark undecided pixels"), 1);
}

TEST(PaletteLines, FindControlsAndOpenTheirSection) {
    UiState state = some_state();
    state.edited.layout.folded = true;
    const PaletteLine line = palette_lines(state, "tint").front();
    EXPECT_EQ(line.text, "tint");
    EXPECT_EQ(line.hint, "in the section Light");
    line.run(state);
    EXPECT_FALSE(state.edited.layout.folded);
    EXPECT_EQ(state.wishes.section, &Layout::light_open);
    for (const PaletteLine& any : palette_lines(state, ""))
        EXPECT_NE(any.text, "tint") << "what is seen in the panel";
    state.edited.read_only = true;
    EXPECT_FALSE(palette_lines(state, "tint").front().enabled);
}

TEST(PaletteLines, KnowEveryLabelOfThePanel) {
    const std::regex label(R"((?:draw_label|draw_amount|draw_vector|draw_part|Checkbox)\()"
                           R"~((?:labelled\()?\s*(?:tr\(|tr_in\("\w+", )"([^"]+)"\))~");
    int labels = 0;
    for (const char* name : {"view", "camera", "look", "light", "clip", "space", "details",
                             "advanced", "section_values"}) {
        std::string path = std::string(ZEROSET_SOURCE_DIR "/ui/panels/") + name;
        path += name == std::string("section_values") ? "_rows.cpp" : "_section.cpp";
        std::ifstream file(path);
        const std::string source(std::istreambuf_iterator<char>(file), {});
        for (std::sregex_iterator at(source.begin(), source.end(), label), end; at != end; ++at) {
            const std::string text = (*at)[1];
            ++labels;
            const auto lines = palette_lines(some_state(), text);
            const auto named = [&](const PaletteLine& line) {
                return contains(line.text, text) || contains(line.other_words, text);
            };
            EXPECT_TRUE(std::ranges::any_of(lines, named)) << text;
        }
    }
    EXPECT_GT(labels, 20);
}

TEST(PaletteLines, GoToSavedViews) {
    UiState state = some_state();
    const Camera here{{0, -3, 0}, {0, 0, 0}, {0, 0, 1}, 1.0};
    const Camera there{{3, 0, 0}, {0, 0, 0}, {0, 0, 1}, 1.0};
    state.edited.document.camera = here;
    state.edited.document.views = {{"front", here}, {"the hole", there}};
    EXPECT_TRUE(palette_lines(state, "go to view front").front().is_on);
    const PaletteLine line = palette_lines(state, "hole").front();
    EXPECT_EQ(line.text, "Go to view the hole");
    EXPECT_EQ(line.hint, "saved view");
    EXPECT_FALSE(line.is_on);
    line.run(state);
    ASSERT_TRUE(state.input.move);
    EXPECT_EQ(state.input.move->to, there);
    EXPECT_EQ(palette_lines(state, "save view").front().hint, "V");
}

TEST(PaletteLines, SayKeysGroupsAndWhatIsOn) {
    UiState state = some_state();
    state.shown.document.can_undo = false;
    const PaletteLine undo = palette_lines(state, "undo").front();
    EXPECT_EQ(undo.hint, "Ctrl+Z");
    EXPECT_FALSE(undo.enabled);
    EXPECT_EQ(palette_lines(state, "torus").front().hint, "Algebraic");
    state.edited.document.mark_undecided = true;
    const PaletteLine mark = palette_lines(state, "mark undecided").front();
    EXPECT_TRUE(mark.is_on);
    mark.run(state);
    EXPECT_FALSE(state.edited.document.mark_undecided);
}

TEST(PaletteLines, AreFoundByOtherWords) {
    const auto first = [](const char* typed) {
        const auto lines = palette_lines(some_state(), typed);
        return lines.empty() ? std::string("nothing") : lines.front().text;
    };
    const auto pictures = texts(palette_lines(some_state(), "picture"));
    EXPECT_LE(std::ranges::find(pictures, "Save the picture...") - pictures.begin(), 1);
    EXPECT_EQ(first("screenshot"), "Save the picture...");
    EXPECT_EQ(first("mesh"), "Save the mesh...");
    EXPECT_EQ(first("stl"), "Save the mesh...");
    EXPECT_EQ(first("full screen"), "Full screen");
    EXPECT_EQ(first("Fullscreen"), "Full screen");
    EXPECT_EQ(first("video"), "Save a film...");
    EXPECT_EQ(first("font"), "Larger letters");
    EXPECT_EQ(first("text size"), "Larger letters");
    EXPECT_EQ(first("lecture"), "Presentation");
    EXPECT_EQ(first("dark mode"), "Light theme");
    EXPECT_EQ(first("singular"), "Snap the marker");
    EXPECT_EQ(first("textbook"), "Axes, box and grid");
    EXPECT_EQ(first("isolines"), "No contour lines");
    const auto camera = palette_lines(some_state(), "camera");
    EXPECT_GE(camera.size(), 10U);
    EXPECT_TRUE(camera.front().text.ends_with("the camera")) << camera.front().text;
    const auto by_word = std::ranges::find(camera, "Reset the view", &PaletteLine::text);
    ASSERT_NE(by_word, camera.end());
    EXPECT_EQ(by_word->found_by, "camera");
    EXPECT_GE(by_word - camera.begin(), 2) << "names come first";
    EXPECT_TRUE(palette_lines(some_state(), "save").front().found_by.empty()) << "the name says it";
    EXPECT_EQ(first("undo"), "Undo") << "names come first";
    EXPECT_EQ(first("section plane"), "Add a section");
    const auto lights = texts(palette_lines(some_state(), "light"));
    for (const char* wanted : {"Add a light", "Section: Light", "Light theme"})
        EXPECT_LT(std::ranges::find(lights, wanted) - lights.begin(), 3) << wanted;
    EXPECT_EQ(first("soft shadow"), "Soft shadows");
}

TEST(PaletteLines, TakeATypedPoint) {
    UiState state = some_state();
    state.edited.document.camera = default_camera(state.edited.document.clip);
    const auto lines = palette_lines(state, "0.5, 1, -2");
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(lines.front().text, "Go to (0.5, 1, -2)");
    lines.front().run(state);
    ASSERT_EQ(state.edited.document.markers.size(), 1U);
    EXPECT_EQ(state.edited.document.markers[0].at, glm::dvec3(0.5, 1, -2));
    ASSERT_TRUE(state.input.move);
    EXPECT_EQ(state.input.move->to.look_at, glm::dvec3(0.5, 1, -2));
}

TEST(TextMatch, FindsPhrases) {
    constexpr std::string_view phrases = "full screen, 3d print, png";
    EXPECT_EQ(phrase_found(phrases, "FULLSC"), "full screen");
    EXPECT_EQ(phrase_found(phrases, "full sc"), "full screen");
    EXPECT_EQ(phrase_found(phrases, "screen"), "full screen");
    EXPECT_EQ(phrase_found(phrases, "print"), "3d print");
    EXPECT_EQ(phrase_found(phrases, "png"), "png");
    for (const char* typed : {"", " ", "creen", "pngs", "screen full", ",", "l s"})
        EXPECT_EQ(phrase_found(phrases, typed), "") << typed;
}

class CommandPalettes : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        state_.shown.gallery = some_state().shown.gallery;
        state_.shown.document.recent = some_state().shown.document.recent;
        draw();
        press_with_ctrl(GLFW_KEY_K);
        draw();
    }
    void run(const char* typed) {
        OffscreenWindow::type(typed);
        draw();
        press(GLFW_KEY_ENTER);
    }
};

TEST_P(CommandPalettes, RunWhatEnterChooses) {
    ASSERT_TRUE(state_.pages.commands.open);
    run("und pix");
    EXPECT_TRUE(state_.edited.document.mark_undecided);
    EXPECT_FALSE(state_.pages.commands.open);
    press_with_ctrl(GLFW_KEY_K);
    draw();
    EXPECT_EQ(state_.pages.commands.typed, "") << "begins anew";
    run("torus");
    EXPECT_EQ(state_.wishes.gallery_item, 0U);
    press_with_ctrl(GLFW_KEY_K);
    draw();
    run("unduloid");
    EXPECT_EQ(state_.wishes.open_path, "/some/where/unduloid.zeroset.json");
}

TEST_P(CommandPalettes, LeaveWhatCannotBeDoneNow) {
    run("undo");
    EXPECT_FALSE(state_.wishes.command);
    EXPECT_TRUE(state_.pages.commands.open);
    press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(state_.pages.commands.open);
    EXPECT_FALSE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup));
}

TEST_P(CommandPalettes, KeepTheKeyboardWhereNothingIsFound) {
    run("zzzz");
    draw();
    EXPECT_TRUE(state_.pages.commands.open);
    EXPECT_TRUE(state_.pages.commands.has_keyboard);
    run("torus");
    EXPECT_EQ(state_.wishes.gallery_item, 0U) << "what is typed then takes the place of it";
}

TEST_P(CommandPalettes, ShowTheSectionOfAControl) {
    run("mirrors");
    EXPECT_FALSE(state_.pages.commands.open);
    draw();
    EXPECT_TRUE(state_.edited.layout.light_open);
    EXPECT_EQ(state_.wishes.section, nullptr);
    const ImGuiWindow* const light = section("light");
    ASSERT_NE(light, nullptr);
    EXPECT_LT(light->Pos.y + ImGui::GetFrameHeight(), child("##side/##list_")->Rect().Max.y);
}

TEST_P(CommandPalettes, AreWalkedThroughByArrows) {
    press(GLFW_KEY_UP);
    EXPECT_EQ(state_.pages.commands.selected, 0U);
    const auto lines = palette_lines(state_, "");
    const auto wanted = std::ranges::find(lines, "Mark undecided pixels", &PaletteLine::text);
    ASSERT_NE(wanted, lines.end());
    for (auto line = lines.begin(); line != wanted; ++line)
        press(GLFW_KEY_DOWN);
    press(GLFW_KEY_ENTER);
    EXPECT_TRUE(state_.edited.document.mark_undecided);
}

TEST_P(CommandPalettes, AreNoLargerThanWhatTheyHaveFound) {
    const auto height = [] {
        return ImGui::GetCurrentContext()->OpenPopupStack.back().Window->Size.y;
    };
    const float all = height();
    OffscreenWindow::type("zzzzzz");
    draw();
    const float none = height();
    EXPECT_LT(none, 0.5F * all);
    EXPECT_GT(none, 2.0F * ImGui::GetFrameHeight()) << "it says that nothing is found";
}

TEST_P(CommandPalettes, OpenThePageTheyName) {
    run("gallery");
    draw();
    EXPECT_TRUE(state_.pages.gallery.open);
    EXPECT_TRUE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup));
}

INSTANTIATE_TEST_SUITE_P(Looks, CommandPalettes, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::command_palette_test
