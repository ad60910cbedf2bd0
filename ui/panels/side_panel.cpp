#include "engine/base/translation.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/sections.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/keys.hpp"
#include "ui/style/label.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/scroll_fade.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace zeroset::ui {
namespace {

constexpr ImGuiWindowFlags bar_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoFocusOnAppearing |
                                       ImGuiWindowFlags_NoScrollWithMouse;

float button_size() { return std::ceil(em(2.0F)); }

/// Draws the action as an icon button whose tooltip shows its name and keys.
void draw_action(UiState& state, const char* name, Icon icon, IconLook look) {
    const Action& action = action_named(name);
    look.enabled = is_enabled(action, state);
    if (icon_button(name, icon, look, described(action))) action.run(state);
}

void draw_gallery_button(UiState& state, const ImVec2& size) {
    const Action& action = action_named("Gallery");
    if (ImGui::Button(tr(action.name), size)) action.run(state);
    draw_tooltip(described(action));
}

void draw_header(UiState& state) {
    const Palette& colors = palette(state.edited.theme);
    const float size = button_size();
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    const IconLook look{.size = size, .color = colors.quiet};
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(em(0.2F), em(0.4F)));
    draw_document_menu(state, look);
    ImGui::SameLine();
    draw_action(state, "Undo", Icon::Undo, look);
    ImGui::SameLine();
    draw_action(state, "Redo", Icon::Redo, look);
    ImGui::SameLine(0.0F, em(0.5F));
    const float gallery = right - ImGui::GetCursorPosX() - 2.0F * (size + em(0.2F)) - em(0.3F);
    draw_gallery_button(state, ImVec2(std::clamp(gallery, em(5.0F), em(9.0F)), size));
    ImGui::SameLine(right - 2.0F * size - em(0.2F));
    draw_action(state, "Help", Icon::Help, look);
    ImGui::SameLine(right - size);
    draw_action(state, "Fold the panel", Icon::Fold, look);
    ImGui::PopStyleVar();
}

/// Draws the title line of a section; a click opens or closes the section.
void draw_section_title(const char* id, const char* title, bool& open, const Palette& colors) {
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const float height = std::ceil(em(1.9F));
    if (ImGui::InvisibleButton(id, ImVec2(ImGui::GetContentRegionAvail().x, height))) {
        open = !open;
    }
    draw_focus_ring();
    const std::uint32_t color = ImGui::IsItemHovered() ? colors.text : colors.quiet;
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    const float middle = lo.y + 0.5F * height;
    draw_icon(canvas, open ? Icon::Down : Icon::Unfold, ImVec2(lo.x + em(0.6F), middle), em(0.7F),
              color);
    canvas.AddText(ImVec2(lo.x + em(1.5F), middle - 0.5F * ImGui::GetFontSize()), color, title);
}

/// Draws the panel's right edge and lets the user drag it.
void draw_edge(Layout& layout, float width, float height, const Palette& colors) {
    const ImRect grip(ImVec2(width - em(0.5F), 0.0F), ImVec2(width, height));
    const ImGuiID id = ImGui::GetID("##edge");
    bool hovered = false;
    bool held = false;
    // The edge is added without layout: it lies beside the content.
    ImGui::PushClipRect(ImVec2(0.0F, 0.0F), grip.Max, false);
    if (ImGui::ItemAdd(grip, id)) ImGui::ButtonBehavior(grip, id, &hovered, &held);
    const bool lit = held || hovered;
    if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (held) {
        const float most = most_of_window * ImGui::GetIO().DisplaySize.x / em(1.0F);
        const float wished = ImGui::GetIO().MousePos.x / em(1.0F);
        layout.panel_em = std::clamp(wished, narrowest_em, std::max(most, narrowest_em));
    }
    const float thick = em(lit ? 0.15F : 1.0F / 14.0F);
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    canvas.AddRectFilled(ImVec2(width - thick, 0.0F), ImVec2(width, height),
                         lit ? colors.accent : colors.border);
    ImGui::PopClipRect();
}

/// A section below the list of statements, with the flag that says whether it is open.
struct FoldedSection {
    const char* title;
    const char* id;
    bool Layout::* open;
    void (*draw)(UiState&);
    float (*height)(const UiState&);  ///< height of the contents in window coordinates
};
constexpr std::array<FoldedSection, 9> sections{
    {{.title = "View",
      .id = "##view",
      .open = &Layout::view_open,
      .draw = draw_view_section,
      .height = [](const UiState&) { return view_section_height(); }},
     {.title = "Camera",
      .id = "##camera",
      .open = &Layout::camera_open,
      .draw = draw_camera_section,
      .height = camera_section_height},
     {.title = "Look",
      .id = "##look",
      .open = &Layout::look_open,
      .draw = [](UiState& state) { draw_look_section(state.edited, state.shown); },
      .height =
          [](const UiState& state) {
              return look_section_height(state.edited.document, state.shown.reading);
          }},
     {.title = "Light",
      .id = "##light",
      .open = &Layout::light_open,
      .draw = [](UiState& state) { draw_light_section(state); },
      .height = [](const UiState& state) { return light_section_height(state.edited.document); }},
     {.title = "Clip",
      .id = "##clip",
      .open = &Layout::clip_open,
      .draw = [](UiState& state) { draw_clip_section(state.edited, state.shown, state.wishes); },
      .height = [](const UiState& state) { return clip_section_height(state.edited); }},
     {.title = "Navigation",
      .id = "##space",
      .open = &Layout::space_open,
      .draw = draw_space_section,
      .height = [](const UiState&) { return space_section_height(); }},
     {.title = "Markers",
      .id = "##markers",
      .open = &Layout::markers_open,
      .draw = draw_marker_section,
      .height = marker_section_height},
     {.title = "Details",
      .id = "##details",
      .open = &Layout::details_open,
      .draw = [](UiState& state) { draw_details_section(state.edited, state.shown); },
      .height =
          [](const UiState& state) {
              return details_section_height(state.edited.document, state.shown);
          }},
     {.title = "Expert",
      .id = "##advanced",
      .open = &Layout::advanced_open,
      .draw = draw_advanced_section,
      .height = advanced_section_height}}};

/// Keeps ImGui's marks of where the keyboard is in one order with those of the whole panel.
constexpr ImGuiWindowFlags part_flags = ImGuiWindowFlags_NavFlattened;

void draw_below(UiState& state) {
    for (const FoldedSection& section : sections) {
        ImGui::Separator();
        if (section.open == state.wishes.section) {
            state.edited.layout.*section.open = true;
            state.wishes.section = nullptr;
            ImGui::SetScrollHereY(0.0F);
        }
        draw_section_title(section.title, tr(section.title), state.edited.layout.*section.open,
                           palette(state.edited.theme));
        if (!(state.edited.layout.*section.open)) continue;
        // The field into which a point is to be typed must be in sight.
        if (section.open == &Layout::markers_open && state.wishes.point_field)
            ImGui::SetScrollHereY(0.0F);
        ImGui::BeginChild(section.id, ImVec2(0.0F, section.height(state)), false, part_flags);
        section.draw(state);
        ImGui::EndChild();
    }
}

void draw_folded(UiState& state) {
    const float size = button_size();
    ImGui::SetNextWindowPos(ImVec2(em(0.6F), em(0.6F)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(em(0.2F), em(0.2F)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
    if (ImGui::Begin("##unfold", nullptr, bar_flags | ImGuiWindowFlags_AlwaysAutoResize)) {
        draw_action(state, "Fold the panel", Icon::Unfold,
                    {.size = size, .color = palette(state.edited.theme).quiet});
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

/// Draws the list of statements and the sections below it, which scroll together. The sections hang
/// from the list, so that the title of one that opens stays under the pointer.
void draw_sections(UiState& state) {
    ImGui::BeginChild("##list", ImVec2(0.0F, 0.0F), false, part_flags);
    draw_statement_list(state);
    ImGui::Dummy(ImVec2(0.0F, em(0.6F)));
    draw_below(state);
    draw_scroll_fade(palette(state.edited.theme).bar);
    ImGui::EndChild();
}

/// Begins the walk of the keyboard through the panel, where Tab is pressed while it is nowhere.
void follow_tab() {
    const ImGuiContext& gui = *ImGui::GetCurrentContext();
    const bool nowhere =
        gui.NavWindow == nullptr || (gui.NavWindow->Flags & ImGuiWindowFlags_NoNavInputs) != 0;
    const ImGuiIO& io = ImGui::GetIO();
    const bool alone = !io.KeyCtrl && !io.KeyAlt && !io.KeyShift;
    const bool popup = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
    if (nowhere && alone && !popup && !io.WantTextInput && is_pressed(ImGuiKey_Tab))
        ImGui::SetKeyboardFocusHere();
}

}  // namespace

void draw_side_panel(UiState& state) {
    if (state.wishes.section != nullptr) state.edited.layout.folded = false;
    if (state.edited.layout.folded) return draw_folded(state);
    const Palette& colors = palette(state.edited.theme);
    const float width = side_panel_width(state.edited.layout);
    const float height = ImGui::GetIO().DisplaySize.y - status_bar_height();
    ImGui::SetNextWindowPos(ImVec2(0.0F, 0.0F));
    ImGui::SetNextWindowSize(ImVec2(width, height));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(em(0.6F), em(0.6F)));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colors.bar);
    const bool open =
        ImGui::Begin("##side", nullptr, bar_flags | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
    if (open) {
        // Tab stops at all controls, not only at fields.
        ImGui::PushItemFlag(ImGuiItemFlags_Inputable, true);
        follow_tab();
        draw_header(state);
        draw_sections(state);
        ImGui::PopItemFlag();
        draw_edge(state.edited.layout, width, height, colors);
    }
    ImGui::End();
}

}  // namespace zeroset::ui
