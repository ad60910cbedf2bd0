#include "ui/panels/statement_row.hpp"

#include "document/sheet.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/base/translation.hpp"
#include "ui/actions/action_functions.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/row_answer.hpp"
#include "ui/panels/statement_field.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/chord.hpp"
#include "ui/widgets/color_picker.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace zeroset::ui {
namespace {

/// Widths of grip, swatch and buttons beside the field, in em.
constexpr float grip_em = 0.9F;
constexpr float swatch_em = 1.5F;
constexpr float button_em = 1.5F;

RowEvent event_of(FieldEvent event) {
    switch (event) {
        case FieldEvent::None: return RowEvent::None;
        case FieldEvent::NextRow: return RowEvent::Next;
        case FieldEvent::Up: return RowEvent::FocusUp;
        case FieldEvent::Down: return RowEvent::FocusDown;
        case FieldEvent::TabForward: return RowEvent::FocusNext;
        case FieldEvent::TabBackward: return RowEvent::FocusPrevious;
        case FieldEvent::DeleteBack: return RowEvent::RemoveBack;
        case FieldEvent::DeleteAhead: return RowEvent::RemoveAhead;
        case FieldEvent::MoveUp: return RowEvent::MoveUp;
        case FieldEvent::MoveDown: return RowEvent::MoveDown;
        case FieldEvent::Duplicate: return RowEvent::Duplicate;
        case FieldEvent::Paste: return RowEvent::Split;
    }
    return RowEvent::None;
}

/// Draws the grip. Dragging it past the middle of a neighbouring row exchanges the two rows.
RowEvent draw_grip(const Row& row, float height) {
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("##grip", ImVec2(em(grip_em), height));
    draw_focus_ring();
    const bool dragged = ImGui::IsItemActive();
    if (row.hovered || dragged) {
        const std::uint32_t color = dragged ? row.colors.accent : row.colors.quiet;
        draw_icon(*ImGui::GetWindowDrawList(), Icon::Grip,
                  ImVec2(lo.x + em(0.4F), lo.y + 0.5F * height), em(0.9F), color);
    }
    if (ImGui::IsItemHovered() || dragged) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    if (!dragged) draw_tooltip(tr("Drag to reorder (Alt + arrows)"));
    if (!dragged || !ImGui::IsMouseDragging(ImGuiMouseButton_Left, em(0.2F))) return RowEvent::None;
    const float pointer = ImGui::GetIO().MousePos.y;
    if (pointer < row.place.Min.y - em(0.3F)) return RowEvent::MoveUp;
    if (pointer > row.place.Max.y + em(0.3F)) return RowEvent::MoveDown;
    return RowEvent::None;
}

/// Draws a sign for the kind of statement in place of a surface's swatch.
void draw_kind(const Row& row, const ImVec2& centre) {
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    if (row.is_broken()) {
        canvas.AddCircleFilled(centre, em(0.42F), row.colors.error);
        canvas.AddRectFilled(ImVec2(centre.x - em(0.06F), centre.y - em(0.24F)),
                             ImVec2(centre.x + em(0.06F), centre.y + em(0.06F)), row.colors.bar);
        canvas.AddRectFilled(ImVec2(centre.x - em(0.06F), centre.y + em(0.14F)),
                             ImVec2(centre.x + em(0.06F), centre.y + em(0.26F)), row.colors.bar);
        return;
    }
    if (row.report == nullptr || row.report->readings.empty()) return;
    const bool function = row.report->readings.front().kind == StatementKind::Function;
    const char* const sign = function ? "f" : "=";
    const ImVec2 size = ImGui::CalcTextSize(sign);
    canvas.AddText(ImVec2(centre.x - 0.5F * size.x, centre.y - 0.5F * size.y), row.colors.quiet,
                   sign);
}

/// The meaning of the sign in place of a swatch, in words; empty: there is none.
std::string kind_name(const Row& row) {
    if (row.is_broken()) return row.error()->reason;
    if (row.report == nullptr || row.report->readings.empty()) return "";
    const bool function = row.report->readings.front().kind == StatementKind::Function;
    return function ? tr("A function") : tr("A constant");
}

void draw_swatch(const Row& row, float height) {
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const ImVec2 centre(lo.x + 0.5F * em(swatch_em), lo.y + 0.5F * height);
    if (!row.is_surface() || row.is_broken()) {
        ImGui::Dummy(ImVec2(em(swatch_em), height));
        draw_tooltip(kind_name(row));
        return draw_kind(row, centre);
    }
    if (ImGui::InvisibleButton("##swatch", ImVec2(em(swatch_em), height))) {
        ImGui::OpenPopup("##color");
    }
    draw_focus_ring();
    draw_color_dot(*ImGui::GetWindowDrawList(), centre, em(0.5F), row.statement, row.colors,
                   ImGui::IsItemHovered());
    draw_tooltip(tr("Color and solid"));
    const auto& thick = row.state.shown.reading.thick_rows;
    draw_surface_popup("##color", row.statement,
                       {.is_thick = std::ranges::find(thick, row.statement.id) != thick.end(),
                        .clip = row.state.edited.document.clip},
                       row.colors);
}

/// Draws the eye and the cross at the right end of the row.
RowEvent draw_buttons(const Row& row, float height) {
    const float size = em(button_em);
    const float left = ImGui::GetCursorPosX();
    const float top = ImGui::GetCursorPosY() + 0.5F * (height - size);
    Statement& statement = row.statement;
    const IconLook look{.size = size, .color = row.colors.quiet};
    if (row.is_surface()) {
        ImGui::SetCursorPosY(top);
        const bool seen = statement.visible;
        if (icon_button("##eye", seen ? Icon::Eye : Icon::ClosedEye, look,
                        seen ? tr("Hide") : tr("Show"))) {
            statement.visible = !seen;
        }
    }
    if (!row.hovered && !row.typing) return RowEvent::None;
    ImGui::SetCursorPos(ImVec2(left + size, top));
    const bool removed = icon_button("##remove", Icon::Cross, look, tr("Remove"));
    return removed ? RowEvent::RemoveAhead : RowEvent::None;
}

RowEvent draw_menu(const Row& row) {
    RowEvent event = RowEvent::None;
    if (!ImGui::BeginPopup("##row menu")) return event;
    const auto item = [&event](const char* label, const char* keys, RowEvent does) {
        if (ImGui::MenuItem(label, keys)) event = does;
    };
    item(tr("Duplicate"), keys_in_language("Ctrl+D").c_str(), RowEvent::Duplicate);
    item(tr("Move up"), keys_in_language("Alt+Up").c_str(), RowEvent::MoveUp);
    item(tr("Move down"), keys_in_language("Alt+Down").c_str(), RowEvent::MoveDown);
    if (row.report != nullptr && !row.report->readings.empty()) {
        if (ImGui::MenuItem(tr("Copy the reading"))) {
            ImGui::SetClipboardText(row.report->readings.front().text.c_str());
        }
    }
    ImGui::Separator();
    item(tr("Remove"), "", RowEvent::RemoveAhead);
    ImGui::EndPopup();
    return event;
}

void draw_back(const Row& row, ImDrawList& canvas, const ImRect& place) {
    const float rounding = em(0.4F);
    if (row.typing || row.hovered) {
        const std::uint32_t color = row.typing ? row.colors.row_active : row.colors.row_hovered;
        canvas.AddRectFilled(place.Min, place.Max, color, rounding);
    }
    if (!row.typing && !row.is_broken()) return;
    canvas.AddRectFilled(place.Min, ImVec2(place.Min.x + em(0.2F), place.Max.y),
                         row.is_broken() ? row.colors.error : row.colors.accent, rounding,
                         ImDrawFlags_RoundCornersLeft);
}

/// The row's rectangle with the height it had in the previous frame.
ImRect last_place(ImGuiID id) {
    const ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float height = storage.GetFloat(id, ImGui::GetFrameHeight());
    return {origin.x, origin.y, origin.x + ImGui::GetContentRegionAvail().x, origin.y + height};
}

RowEvent either(RowEvent a, RowEvent b) { return a != RowEvent::None ? a : b; }

/// Draws all parts of the row, starting at ImGui's cursor.
RowEvent draw_parts(Row& row, const char* hint) {
    const float spacing = em(0.3F);
    const float height = statement_field_height("", 0.0F);
    const float left = ImGui::GetCursorPosX();
    const float right = left + ImGui::GetContentRegionAvail().x;
    const float top = ImGui::GetCursorPosY();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, em(0.15F)));
    RowEvent event = draw_grip(row, height);
    ImGui::SameLine();
    draw_swatch(row, height);
    ImGui::SameLine(0.0F, spacing);
    const float field = ImGui::GetCursorPosX();
    const float buttons = 2.0F * em(button_em);
    const float width = std::max(right - buttons - spacing - field, em(4.0F));
    ImGui::PushStyleColor(ImGuiCol_FrameBg, row.typing ? row.colors.field : row.colors.row_field);
    event = either(
        event, event_of(draw_statement_field(row.state, row.statement, row.error(), width, hint)));
    ImGui::PopStyleColor();
    ImGui::SameLine(0.0F, spacing);
    event = either(event, draw_buttons(row, height));
    const float indent = ImGui::GetStyle().FramePadding.x;
    const float tall = statement_field_height(row.statement.text, width);
    // The line ends here, or what comes below would be as tall as the field.
    if (tall > height) ImGui::Dummy(ImVec2(0.0F, 0.0F));
    const float below = top + tall + em(0.15F);
    ImGui::SetCursorPos(ImVec2(field + indent, below));
    draw_row_answer(row, right - field - indent - spacing);
    ImGui::PopStyleVar();
    return event;
}

}  // namespace

RowEvent draw_statement_row(UiState& state, std::size_t index, const char* hint) {
    Statement& statement = state.edited.document.statements[index];
    const auto report = state.shown.reading.reports.find(statement.id);
    ImGui::PushID(statement.id);
    const ImGuiID id = ImGui::GetID("##height");
    const ImRect place = last_place(id);
    const bool free = !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup) &&
                      !ImGui::IsMouseDragging(ImGuiMouseButton_Left) &&
                      ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows |
                                             ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    Row row{.state = state,
            .statement = statement,
            .report = report == state.shown.reading.reports.end() ? nullptr : &report->second,
            .colors = palette(state.edited.theme),
            .place = place,
            .hovered = free && place.Contains(ImGui::GetIO().MousePos),
            .typing = ImGui::GetActiveID() == ImGui::GetID("##equation")};
    if (state.wishes.focus && state.wishes.focus->row == statement.id) {
        ImGui::ScrollToRect(ImGui::GetCurrentWindow(), place);
    }
    draw_back(row, *ImGui::GetWindowDrawList(), place);
    ImGui::BeginGroup();
    RowEvent event = draw_parts(row, hint);
    ImGui::EndGroup();
    const float height = ImGui::GetItemRectSize().y;
    ImGui::GetStateStorage()->SetFloat(id, height);
    if (row.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right))
        ImGui::OpenPopup("##row menu");
    event = either(event, draw_menu(row));
    ImGui::PopID();
    return event;
}

}  // namespace zeroset::ui
