#include "ui/pages/command_palette.hpp"

#include "engine/base/translation.hpp"
#include "ui/actions/action_functions.hpp"
#include "ui/actions/actions.hpp"
#include "ui/actions/other_words.hpp"
#include "ui/actions/panel_controls.hpp"
#include "ui/actions/view_moves.hpp"
#include "ui/model/text_match.hpp"
#include "ui/model/typed_point.hpp"
#include "ui/style/keys.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/scroll_fade.hpp"
#include "ui/widgets/typing_popup.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>

namespace zeroset::ui {
namespace {

constexpr const char* palette_popup = "##command palette";
constexpr float line_em = 1.8F;

/// The words by which a line is found, too, and in another language also its English name.
std::string in_english_too(std::string words, const char* name) {
    if (language() == Language::English) return words;
    return words + (words.empty() ? "" : ", ") + name;
}

std::string all_other_words(const Action& action) {
    const std::string words(other_words_of(action.name));
    return in_english_too(words.empty() ? words : tr(words.c_str()), action.name);
}

std::vector<PaletteLine> action_lines(const UiState& state) {
    std::vector<PaletteLine> lines;
    const Action& finder = action_named("Find a command...");
    for (const Action& action : actions()) {
        if (&action == &finder) continue;
        const bool on = action.is_on != nullptr && action.is_on(state);
        lines.push_back({.text = tr(action.name),
                         .hint = shown_keys(action),
                         .enabled = is_enabled(action, state),
                         .is_on = on,
                         .other_words = all_other_words(action),
                         .run = action.run});
    }
    return lines;
}

/// The lines of the panel's controls, each of which opens its section.
void add_controls(const UiState& state, std::vector<PaletteLine>& lines) {
    const bool enabled = !state.edited.read_only && !state.edited.layout.presents;
    for (const PanelControl& control : panel_controls()) {
        const bool plain = *control.context == '\0';
        lines.push_back({.text = plain ? tr(control.label) : tr_in(control.context, control.label),
                         .hint = filled(tr("in the section {0}"), {tr(control.section)}),
                         .enabled = enabled,
                         .is_control = true,
                         .other_words = in_english_too(tr(control.words), control.label),
                         .run = [open = control.open](UiState& changed) {
                             changed.edited.layout.folded = false;
                             changed.wishes.section = open;
                         }});
    }
}

/// The lines of saved views, of the gallery and of recent files.
void add_documents(const UiState& state, std::vector<PaletteLine>& lines) {
    for (const SavedView& view : state.edited.document.views) {
        lines.push_back(
            {.text = filled(tr("Go to view {0}"), {view.name}),
             .hint = tr("saved view"),
             .enabled = state.edited.document.camera.has_value(),
             .is_on = state.edited.document.camera == view.camera,
             .run = [camera = view.camera](UiState& changed) { move_view(changed, camera); }});
    }
    for (std::size_t i = 0; i < state.shown.gallery.size(); ++i) {
        lines.push_back({.text = tr(state.shown.gallery[i].title.c_str()),
                         .hint = tr(state.shown.gallery[i].group.c_str()),
                         .replaces = true,
                         .run = [i](UiState& changed) { changed.wishes.gallery_item = i; }});
    }
    for (const std::string& path : state.shown.document.recent) {
        lines.push_back({.text = std::filesystem::path(path).filename().string(),
                         .hint = tr("recent file"),
                         .replaces = true,
                         .run = [path](UiState& changed) { changed.wishes.open_path = path; }});
    }
}

/// The entry that looks at a typed point and keeps a marker there.
PaletteLine way_to(const glm::dvec3& point, const UiState& state) {
    return {.text = filled(tr("Go to {0}"), {coordinates_text(point)}),
            .hint = tr("point"),
            .enabled = state.edited.document.camera.has_value(),
            .run = [point](UiState& changed) { go_to(changed, point); }};
}

/// How well the entry is found, nothing where it is not; says which of its other words did.
std::optional<Match> score_of(PaletteLine& line, const std::string& typed) {
    if (typed.empty()) return Match();
    auto by_name = match_of(line.text, typed);
    // Letters that happen to stand somewhere in a name are no reason to leave a document.
    if (by_name && line.replaces && by_name->closeness == Closeness::Scattered) by_name.reset();
    // A word counts less than it does in a name, and the label of a control less than a command's.
    constexpr int for_the_name = 32;
    constexpr int for_a_command = 32;
    if (by_name && line.is_control) by_name->score -= for_a_command;
    const std::string_view word = phrase_found(line.other_words, typed);
    if (word.empty()) return by_name;
    Match by_word = match_of(word, typed).value_or(Match());
    by_word.closeness = std::max(by_word.closeness, Closeness::Beginnings);
    by_word.score -= for_the_name;
    if (by_name && *by_name >= by_word) return by_name;
    line.found_by = word;
    return by_word;
}

/// Draws a tick before the text of a switch that is on.
void draw_tick(const ImVec2& lo, float height, const Palette& colors) {
    const float size = em(0.45F);
    const ImVec2 at(lo.x + em(0.7F), lo.y + 0.5F * height + 0.1F * size);
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    const float thick = em(0.12F);
    canvas.AddLine(ImVec2(at.x - size, at.y), ImVec2(at.x - 0.4F * size, at.y + 0.6F * size),
                   colors.accent, thick);
    canvas.AddLine(ImVec2(at.x - 0.4F * size, at.y + 0.6F * size),
                   ImVec2(at.x + 0.7F * size, at.y - 0.8F * size), colors.accent, thick);
}

/// Draws one line; true if it was clicked.
bool draw_line(const PaletteLine& line, bool selected, const Palette& colors) {
    const float height = em(line_em);
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::Selectable("##line", selected, ImGuiSelectableFlags_DontClosePopups,
                                           ImVec2(0.0F, height));
    if (!ImGui::IsItemVisible()) return clicked;
    const float right = ImGui::GetItemRectMax().x - em(0.6F);
    const float top = lo.y + 0.5F * (height - ImGui::GetFontSize());
    const float hint = right - ImGui::CalcTextSize(line.hint.c_str()).x;
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    if (line.is_on) draw_tick(lo, height, colors);
    const float left = lo.x + em(1.5F);
    const float space = hint - em(0.6F) - left;
    const std::string text = elided(line.text, space);
    canvas.AddText(ImVec2(left, top), line.enabled ? colors.text : colors.quiet, text.c_str());
    if (!line.found_by.empty()) {
        const float after = ImGui::CalcTextSize(text.c_str()).x + em(0.8F);
        canvas.AddText(ImVec2(left + after, top), colors.quiet,
                       elided(line.found_by, space - after).c_str());
    }
    canvas.AddText(ImVec2(hint, top), colors.quiet, line.hint.c_str());
    return clicked;
}

void follow_arrows(CommandPalette& palette, std::size_t count) {
    const std::size_t before = palette.selected;
    if (is_pressed(ImGuiKey_UpArrow) && palette.selected > 0) --palette.selected;
    if (is_pressed(ImGuiKey_DownArrow)) ++palette.selected;
    palette.selected = std::min(palette.selected, count - 1);
    if (palette.selected != before) palette.follow = true;
}

/// Draws all lines; returns the index of the clicked one, if any.
std::optional<std::size_t> draw_lines(UiState& state, const std::vector<PaletteLine>& lines) {
    CommandPalette& shown = state.pages.commands;
    std::optional<std::size_t> clicked;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (draw_line(lines[i], i == shown.selected, palette(state.edited.theme))) clicked = i;
        if (i == shown.selected && std::exchange(shown.follow, false)) {
            const ImRect place(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
            ImGui::ScrollToRect(ImGui::GetCurrentWindow(), place,
                                ImGuiScrollFlags_KeepVisibleEdgeY);
        }
        ImGui::PopID();
    }
    return clicked;
}

void draw_field(CommandPalette& palette) {
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (draw_popup_field(palette, tr("a command, a surface, a recent file"), palette.typed)) {
        palette.selected = 0;
        palette.follow = true;
    }
}

void draw_palette(UiState& state) {
    CommandPalette& shown = state.pages.commands;
    draw_field(shown);
    const std::vector<PaletteLine> lines = palette_lines(state, shown.typed);
    shown.found = lines.size();
    std::optional<std::size_t> picked;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    ImGui::BeginChild("##lines", ImVec2(0.0F, 0.0F), false, ImGuiWindowFlags_NoNav);
    if (lines.empty()) {
        ImGui::TextDisabled("%s", tr("nothing found"));
    } else {
        follow_arrows(shown, lines.size());
        picked = draw_lines(state, lines);
        draw_scroll_fade(ImGui::GetColorU32(ImGuiCol_PopupBg) | IM_COL32_A_MASK);
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    const bool enter = is_pressed_once(ImGuiKey_Enter) || is_pressed_once(ImGuiKey_KeyPadEnter);
    if (enter && !lines.empty()) picked = shown.selected;
    if (is_pressed_once(ImGuiKey_Escape)) shown.open = false;
    if (!picked || !lines[*picked].enabled) return;
    shown.open = false;
    lines[*picked].run(state);
}

}  // namespace

std::vector<PaletteLine> palette_lines(const UiState& state, const std::string& typed) {
    std::vector<PaletteLine> lines;
    if (const auto point = point_typed(typed)) lines.push_back(way_to(*point, state));
    std::vector<PaletteLine> all = action_lines(state);
    if (!typed.empty()) add_controls(state, all);
    add_documents(state, all);
    std::vector<std::pair<Match, PaletteLine>> scored;
    for (PaletteLine& line : all) {
        if (const auto score = score_of(line, typed)) scored.emplace_back(*score, std::move(line));
    }
    std::ranges::stable_sort(scored, std::ranges::greater{},
                             [](const auto& entry) { return entry.first; });
    // Scattered letters are for those who type an abbreviation.
    const bool has_words = !scored.empty() && scored.front().first.closeness > Closeness::Scattered;
    for (auto& [score, line] : scored) {
        if (has_words && score.closeness == Closeness::Scattered) break;
        lines.push_back(std::move(line));
    }
    return lines;
}

void draw_command_palette(UiState& state) {
    CommandPalette& shown = state.pages.commands;
    if (!follow_popup(shown, palette_popup)) return;
    if (shown.frames == 1) {
        shown.typed.clear();
        shown.selected = 0;
        shown.found = palette_lines(state, "").size();
    }
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float lines = static_cast<float>(std::max<std::size_t>(shown.found, 1)) * em(line_em);
    const float needed =
        2.0F * style.WindowPadding.y + ImGui::GetFrameHeight() + style.ItemSpacing.y + lines;
    const ImVec2 size(std::min(em(36.0F), 0.95F * window.x),
                      std::ceil(std::min({em(28.0F), 0.85F * window.y, needed})));
    ImGui::SetNextWindowPos(ImVec2(0.5F * (window.x - size.x), 0.06F * window.y));
    ImGui::SetNextWindowSize(size);
    draw_popup(shown, palette_popup, [&] { draw_palette(state); });
}

}  // namespace zeroset::ui
