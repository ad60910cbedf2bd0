#include "engine/base/translation.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/text_match.hpp"
#include "ui/pages/pages_drawn.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/keys.hpp"
#include "ui/style/label.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/chord.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <cfloat>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

/// Help on pointer gestures and text fields, listed before the actions of the same section.
std::vector<HelpSection> gestures_help() {
    return {
        {.title = "Picture",
         .entries = {{.typed = "left drag", .meaning = "orbit"},
                     {.typed = "right drag, Shift + left drag", .meaning = "pan"},
                     {.typed = "wheel", .meaning = "zoom towards the cursor"},
                     {.typed = "double click", .meaning = "centre on the point of the surface"},
                     {.typed = "balls at the upper right",
                      .meaning = "click: view along an axis; drag: orbit"},
                     {.typed = "rest the pointer", .meaning = "the status line says what is there"},
                     {.typed = "click on a surface",
                      .meaning = "keep a marker there; on a marker: select it"},
                     {.typed = "drag a handle",
                      .meaning =
                          "move a face of the clip box, the sphere, a section; Esc gives it up"},
                     {.typed = "Shift with a face",
                      .meaning = "moves the opposite one, too; Ctrl: all of them"},
                     {.typed = "Shift with a section's ball",
                      .meaning = "turns it to axes and diagonals only"}}},
        {.title = "Statements",
         .entries = {{.typed = "Enter", .meaning = "a new row below"},
                     {.typed = "Shift+Enter", .meaning = "a new line in the row"},
                     {.typed = "Up, Down", .meaning = "to the row above, below"},
                     {.typed = "Tab, Shift+Tab", .meaning = "to the next row, the one before"},
                     {.typed = "Esc", .meaning = "leave the row"},
                     {.typed = "Backspace in an empty row", .meaning = "remove it"},
                     {.typed = "Alt+Up, Alt+Down", .meaning = "move the row"},
                     {.typed = "Ctrl+D", .meaning = "duplicate the row"}}},
        {.title = "Sliders",
         .entries = {{.typed = "drag", .meaning = "change the value"},
                     {.typed = "double-click, Ctrl+click",
                      .meaning = "type a number, beyond the slider's ends, too"},
                     {.typed = "right click", .meaning = "back to the usual value and range"}}}};
}

const std::vector<HelpSection>& keys_help() {
    static const std::vector<HelpSection> sections = [] {
        std::vector<HelpSection> all = gestures_help();
        for (const Action& action : actions()) {
            if (*action.keys == '\0') continue;
            auto section = std::ranges::find(all, action.section, &HelpSection::title);
            if (section == all.end())
                section = all.insert(all.end(), {.title = action.section, .entries = {}});
            const bool named = *action.about == '\0';
            section->entries.push_back(
                {.typed = action.keys, .meaning = named ? action.name : action.about});
        }
        return all;
    }();
    return sections;
}

/// The typed text in the user's language: formulas are the same in all of them.
std::string typed_text(const HelpEntry& entry, FontRole typed) {
    if (typed == FontRole::SmallFormula) return entry.typed;
    return keys_in_language(tr(entry.typed.c_str()));
}

std::vector<HelpEntry> filtered(const HelpSection& section, const std::string& filter,
                                FontRole typed) {
    if (contains(tr(section.title.c_str()), filter)) return section.entries;
    std::vector<HelpEntry> found;
    for (const HelpEntry& entry : section.entries) {
        if (contains(typed_text(entry, typed), filter) ||
            contains(tr(entry.meaning.c_str()), filter)) {
            found.push_back(entry);
        }
    }
    return found;
}

void draw_entries(const std::vector<HelpEntry>& entries, FontRole typed, const Palette& colors) {
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX;
    if (!ImGui::BeginTable("##entries", 2, flags)) return;
    ImGui::TableSetupColumn("typed", ImGuiTableColumnFlags_WidthStretch, 0.42F);
    ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch, 0.58F);
    for (const HelpEntry& entry : entries) {
        ImGui::TableNextColumn();
        ImGui::PushFont(font(typed));
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextUnformatted(typed_text(entry, typed).c_str());
        ImGui::PopFont();
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, colors.quiet);
        ImGui::TextUnformatted(tr(entry.meaning.c_str()));
        ImGui::PopStyleColor();
        ImGui::PopTextWrapPos();
    }
    ImGui::EndTable();
}

/// Draws the sections as far as they match `filter`; true if anything matched.
bool draw_sections(const std::vector<HelpSection>& sections, const std::string& filter,
                   FontRole typed, const Palette& colors) {
    bool any = false;
    for (const HelpSection& section : sections) {
        const std::vector<HelpEntry> entries = filtered(section, filter, typed);
        if (entries.empty()) continue;
        ImGui::PushID(&section);
        if (any) ImGui::Dummy(ImVec2(0.0F, em(0.3F)));
        ImGui::PushStyleColor(ImGuiCol_Text, colors.accent);
        ImGui::TextUnformatted(tr(section.title.c_str()));
        ImGui::PopStyleColor();
        draw_entries(entries, typed, colors);
        ImGui::PopID();
        any = true;
    }
    return any;
}

void draw_language(HelpPage& page, const std::vector<HelpSection>& language,
                   const Palette& colors) {
    ImGui::SetNextItemWidth(-FLT_MIN);
    ImGui::InputTextWithHint("##filter", tr("find a function, for example  root"), &page.filter);
    ImGui::BeginChild("##language", ImVec2(0.0F, 0.0F));
    if (!draw_sections(language, page.filter, FontRole::SmallFormula, colors)) {
        ImGui::TextDisabled("%s", tr("nothing found"));
    }
    ImGui::EndChild();
}

void draw_keys(const Palette& colors) {
    ImGui::BeginChild("##keys", ImVec2(0.0F, 0.0F));
    draw_sections(keys_help(), "", FontRole::Text, colors);
    ImGui::EndChild();
}

/// Places the window at the right above the status line, or over that if the window is too low.
void place_window() {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float margin = std::min(em(1.0F), 0.02F * window.y);
    const float top = margin;
    const float bottom = window.y - status_bar_height() - margin;
    const ImVec2 size(
        std::min(em(48.0F), window.x - 2.0F * margin),
        std::clamp(bottom - top, std::min(em(34.0F), window.y - 2.0F * margin), em(50.0F)));
    ImGui::SetNextWindowPos(
        ImVec2(window.x - margin - size.x, std::clamp(top, margin, window.y - margin - size.y)),
        ImGuiCond_Appearing);
    ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
    ImGui::SetNextWindowSizeConstraints(ImVec2(std::min(em(20.0F), window.x), em(12.0F)), window);
}

}  // namespace

void follow_help_keys(HelpPage& page, const Input& input) {
    const bool is_for_others =
        ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup) || input.handle_drag.has_value();
    if (!page.open || is_for_others) return;
    const int escape = ImGui::GetKeyIndex(ImGuiKey_Escape);
    if (escape < 0 || !ImGui::IsKeyPressed(escape, false)) return;
    page.open = false;
    // Mark Escape as no longer just pressed: otherwise the text field would discard what was typed.
    ImGui::GetIO().KeysDownDuration[escape] = FLT_MIN;
}

void draw_help_panel(HelpPage& page, const std::vector<HelpSection>& language, Theme theme) {
    if (!page.open) {
        page.filter.clear();
        return;
    }
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoFocusOnAppearing |
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    const Palette& colors = palette(theme);
    place_window();
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colors.popup);
    const bool open = ImGui::Begin(labelled(tr("Help"), "###help").c_str(), &page.open, flags);
    ImGui::PopStyleColor();
    if (open) {
        if (ImGui::IsWindowAppearing()) {
            ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
        }
        if (ImGui::BeginTabBar("##tabs")) {
            if (ImGui::BeginTabItem(tr("Formulas"))) {
                draw_language(page, language, colors);
                ImGui::EndTabItem();
            }
            if (ImGui::BeginTabItem(tr("Keys"))) {
                draw_keys(colors);
                ImGui::EndTabItem();
            }
            ImGui::EndTabBar();
        }
    }
    ImGui::End();
}

}  // namespace zeroset::ui
