#include "ui/exports/export_page.hpp"

#include "engine/base/translation.hpp"
#include "ui/exports/export_parts.hpp"
#include "ui/style/keys.hpp"
#include "ui/style/label.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

namespace zeroset::ui {
namespace {

constexpr float narrowest_page_em = 25.0F;
constexpr float widest_page_em = 33.0F;
constexpr float highest_page_em = 56.0F;

struct Tab {
    ExportKind kind;
    const char* name;
};
constexpr std::array<Tab, 4> tabs{{
    {.kind = ExportKind::Picture, .name = "Picture"},
    {.kind = ExportKind::Film, .name = "Film"},
    {.kind = ExportKind::Mesh, .name = "Mesh"},
    {.kind = ExportKind::Drawing, .name = "Drawing"},
}};

/// The format that is chosen for the page's kind; the kind's first one that can be written, where
/// none is chosen or the chosen one cannot be.
const ExportFormat& chosen_format(UiState& state) {
    ExportPage& page = state.pages.exports;
    std::string& ending = page.endings.at(static_cast<std::size_t>(page.wish.kind));
    const auto& formats = state.shown.export_formats;
    const auto can_be = [&](const ExportFormat& format) {
        return format.kind == page.wish.kind && format.missing.empty();
    };
    auto found = std::ranges::find_if(formats, [&](const ExportFormat& format) {
        return can_be(format) && ending == ending_of(format);
    });
    if (found == formats.end()) found = std::ranges::find_if(formats, can_be);
    if (found == formats.end()) found = formats.begin();
    ending = ending_of(*found);
    return *found;
}

std::string shown_name(const ExportFormat& format) {
    return filled(format.numbered ? tr("Numbered {0} ({1})") : "{0} ({1})",
                  {format.name, format.ending});
}

void draw_formats(UiState& state, const ExportFormat& chosen) {
    ExportPage& page = state.pages.exports;
    draw_export_label(tr("format"), tr(std::string(chosen.about).c_str()));
    if (!ImGui::BeginCombo("##format", shown_name(chosen).c_str(), ImGuiComboFlags_HeightLarge))
        return;
    for (const ExportFormat& format : state.shown.export_formats) {
        if (format.kind != page.wish.kind || !format.missing.empty()) continue;
        if (ImGui::Selectable(shown_name(format).c_str(), &format == &chosen))
            page.endings.at(static_cast<std::size_t>(page.wish.kind)) = ending_of(format);
        draw_tooltip(tr(std::string(format.about).c_str()));
    }
    ImGui::EndCombo();
}

/// Says which formats of the page's kind this program cannot write, and why.
void draw_missing(const UiState& state) {
    std::string names;
    std::string reason;
    for (const ExportFormat& format : state.shown.export_formats) {
        if (format.kind != state.pages.exports.wish.kind || format.missing.empty()) continue;
        if (!format.numbered) names += (names.empty() ? "" : ", ") + std::string(format.name);
        reason = format.missing;
    }
    if (names.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, palette(state.edited.theme).quiet);
    ImGui::TextWrapped("%s", filled(tr("No {0}: {1}."), {names, reason}).c_str());
    ImGui::PopStyleColor();
}

void draw_part(UiState& state, const ExportFormat& format) {
    switch (state.pages.exports.wish.kind) {
        case ExportKind::Picture: return draw_picture_part(state, format);
        case ExportKind::Film: return draw_film_part(state, format);
        case ExportKind::Mesh: return draw_mesh_part(state, format);
        case ExportKind::Drawing: return draw_drawing_part(state);
    }
}

/// Draws over a bar of progress that something goes on, where it is not known how far it is.
void draw_going(const ImVec2& lo, float width, std::uint32_t color) {
    constexpr double round_s = 2.0;
    const double phase = std::fmod(ImGui::GetTime(), round_s) / round_s;
    const float part = 0.25F * width;
    const float along = static_cast<float>(1.0 - std::abs(2.0 * phase - 1.0)) * (width - part);
    ImGui::GetWindowDrawList()->AddRectFilled(
        ImVec2(lo.x + along, lo.y), ImVec2(lo.x + along + part, lo.y + ImGui::GetFrameHeight()),
        color, em(0.3F));
}

/// Draws how far an export is, with a button that stops it.
void draw_progress(UiState& state) {
    const ExportProgress& progress = state.shown.export_progress;
    const float button = em(5.0F);
    const float space = ImGui::GetContentRegionAvail().x;
    draw_elided(progress.name + ": " + progress.text, space);
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, palette(state.edited.theme).accent);
    const ImVec2 bar(space - button - spacing, 0.0F);
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    ImGui::ProgressBar(static_cast<float>(progress.share), bar, "");
    if (progress.share <= 0.0) draw_going(lo, bar.x, palette(state.edited.theme).accent);
    ImGui::PopStyleColor();
    ImGui::SameLine();
    if (ImGui::Button(tr("Stop"), ImVec2(button, 0.0F))) state.wishes.stop_export = true;
    draw_tooltip(tr("Nothing is left behind; numbered pictures that are finished stay."));
}

/// Saves to the file that is proposed, or asks for another one.
void save(UiState& state) {
    if (state.shown.export_target.empty()) {
        state.wishes.command = Command::Export;
    } else {
        state.wishes.export_path = state.shown.export_target;
    }
}

/// "picture.png in /home/ann"
void draw_target(const std::string& target) {
    if (target.empty()) return;
    const std::filesystem::path path(target);
    const std::string text =
        filled(tr("{0} in {1}"), {path.filename().string(), path.parent_path().string()});
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    const bool cut = draw_elided(text, ImGui::GetContentRegionAvail().x);
    ImGui::PopStyleColor();
    if (cut) draw_tooltip(text);
}

void draw_save(UiState& state) {
    const Palette& colors = palette(state.edited.theme);
    const std::string& target = state.shown.export_target;
    draw_target(target);
    ImGui::PushStyleColor(ImGuiCol_Button, colors.accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colors.accent);
    ImGui::PushStyleColor(ImGuiCol_Text, colors.bar);
    if (ImGui::Button(target.empty() ? tr("Save...") : tr("Save"), ImVec2(em(6.0F), 0.0F)))
        save(state);
    ImGui::PopStyleColor(3);
    draw_tooltip(target.empty() ? tr("Choose the file's name (Enter)")
                                : filled(tr("Save as {0} (Enter)"), {target}));
    if (!target.empty()) {
        ImGui::SameLine();
        if (ImGui::Button(tr("Save as..."))) state.wishes.command = Command::Export;
        draw_tooltip(tr("Choose the file's name and folder (Shift+Enter)"));
    }
    if (state.pages.exports.wish.kind != ExportKind::Picture) return;
    ImGui::SameLine();
    const float padding = 2.0F * ImGui::GetStyle().FramePadding.x;
    const std::string copy =
        elided(tr("Copy the picture"), ImGui::GetContentRegionAvail().x - padding);
    if (ImGui::Button((copy + "###copy").c_str())) state.wishes.copy_picture = true;
    draw_tooltip(tr("The window's picture to the clipboard (Ctrl+Shift+C)"));
}

/// Draws the list of kinds and, below it, what can be chosen of the kind that is shown.
void draw_content(UiState& state) {
    ExportPage& page = state.pages.exports;
    const bool begins = std::exchange(page.begins, false);
    if (!ImGui::BeginTabBar("##kinds")) return;
    for (const Tab& tab : tabs) {
        const bool chosen = begins && tab.kind == page.wish.kind;
        if (!ImGui::BeginTabItem(tr(tab.name), nullptr,
                                 chosen ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None))
            continue;
        if (!begins) page.wish.kind = tab.kind;
        ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
    const bool saves = !state.shown.export_progress.name.empty();
    const bool two_lines = saves || !state.shown.export_target.empty();
    const float below = (two_lines ? 2.0F : 1.0F) * ImGui::GetFrameHeightWithSpacing() + em(0.6F);
    ImGui::BeginChild("##part", ImVec2(0.0F, -below));
    draw_export_preview(state);
    const ExportFormat& format = chosen_format(state);
    if (page.wish.kind == ExportKind::Film) draw_film_timeline(state);
    draw_formats(state, format);
    draw_missing(state);
    draw_part(state, format);
    // Below the controls, which stay where they are when it arrives.
    draw_export_facts(state);
    ImGui::EndChild();
    ImGui::Separator();
    if (saves) {
        draw_progress(state);
    } else {
        draw_save(state);
    }
}

/// Places the page at the right above the status line, over half of the picture if that is wide.
void place_export_page(const Layout& layout) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float margin = std::min(em(1.0F), 0.02F * window.y);
    const float half_picture = 0.5F * (window.x - side_panel_width(layout));
    const float space = window.y - status_bar_height() - 2.0F * margin;
    const ImVec2 size(std::min(std::clamp(half_picture, em(narrowest_page_em), em(widest_page_em)),
                               window.x - 2.0F * margin),
                      std::min(space, em(highest_page_em)));
    ImGui::SetNextWindowPos(ImVec2(window.x - margin - size.x, margin), ImGuiCond_Appearing);
    ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
    ImGui::SetNextWindowSizeConstraints(ImVec2(std::min(em(20.0F), window.x), em(12.0F)), window);
}

}  // namespace

void follow_export_keys(UiState& state) {
    ExportPage& page = state.pages.exports;
    const bool is_for_others = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup) ||
                               state.input.handle_drag.has_value();
    if (!page.open || is_for_others) return;
    const int escape = ImGui::GetKeyIndex(ImGuiKey_Escape);
    // While a field is typed into, Escape leaves that alone.
    if (escape >= 0 && ImGui::IsKeyPressed(escape, false) && !ImGui::GetIO().WantTextInput)
        page.open = false;
    const bool enter = is_pressed_once(ImGuiKey_Enter) || is_pressed_once(ImGuiKey_KeyPadEnter);
    if (!enter || ImGui::GetIO().WantTextInput || !state.shown.export_progress.name.empty()) return;
    if (ImGui::GetIO().KeyShift) {
        state.wishes.command = Command::Export;
    } else {
        save(state);
    }
}

void draw_export_page(UiState& state) {
    ExportPage& page = state.pages.exports;
    if (!page.open || state.shown.export_formats.empty()) return;
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoFocusOnAppearing |
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    place_export_page(state.edited.layout);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(state.edited.theme).popup);
    const bool open =
        ImGui::Begin(labelled(tr("Save as a file"), "###export").c_str(), &page.open, flags);
    ImGui::PopStyleColor();
    if (open) {
        if (ImGui::IsWindowAppearing()) ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
        draw_content(state);
    }
    ImGui::End();
}

}  // namespace zeroset::ui
