#include "ui/panels/statement_row.hpp"

#include "document/sheet.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/base/translation.hpp"
#include "ui/actions/action_functions.hpp"
#include "ui/model/ui_state.hpp"
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
/// Largest numbers of readings and notes that are shown for one row.
constexpr std::size_t most_readings = 4;
constexpr std::size_t most_notes = 4;
/// The statement that a note proposes by which theta and phi change places.
constexpr std::string_view angles_swapped = "swap theta, phi";
/// Opacity of a reading of an older text, while the new one is not read yet.
constexpr double old_reading_faded = 0.5;

/// Everything that the parts of a row need for drawing.
struct Row {
    UiState& state;
    Statement& statement;
    const RowReport* report;  ///< nullptr: not read yet
    const Palette& colors;
    ImRect place;  ///< from the previous frame, to find the row under the pointer
    bool hovered;
    bool typing;

    [[nodiscard]] bool is_surface() const {
        return std::ranges::find(state.shown.reading.surface_rows, statement.id) !=
               state.shown.reading.surface_rows.end();
    }
    /// Error of the row's current text; nullptr if there is none or it is not read yet.
    [[nodiscard]] const RowError* error() const { return error_of(state, statement); }
};

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
    if (row.error() != nullptr && !row.error()->unfinished) {
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
    if (row.error() != nullptr && !row.error()->unfinished) return row.error()->reason;
    if (row.report == nullptr || row.report->readings.empty()) return "";
    const bool function = row.report->readings.front().kind == StatementKind::Function;
    return function ? tr("A function") : tr("A constant");
}

void draw_swatch(const Row& row, float height) {
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const ImVec2 centre(lo.x + 0.5F * em(swatch_em), lo.y + 0.5F * height);
    const bool broken = row.error() != nullptr && !row.error()->unfinished;
    if (!row.is_surface() || broken) {
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

void draw_readings(const Row& row, float width) {
    ImGui::PushFont(font(FontRole::SmallFormula));
    const bool old =
        row.state.shown.picture.dimmed > 0.0F && row.report->text != row.statement.text;
    const double dimmed = old ? static_cast<double>(row.state.shown.picture.dimmed) : 0.0;
    ImGui::PushStyleColor(ImGuiCol_Text, faded(row.colors.quiet, 1.0 - old_reading_faded * dimmed));
    const auto& readings = row.report->readings;
    for (std::size_t i = 0; i < std::min(readings.size(), most_readings); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const ImVec2 at = ImGui::GetCursorPos();
        const std::string line = in_one_line(readings[i].text);
        const bool cut = draw_elided(line, width);
        draw_tooltip((cut ? readings[i].text + "\n\n" : "") + tr("Click: copy"), 60.0F);
        if (ImGui::IsItemClicked()) ImGui::SetClipboardText(readings[i].text.c_str());
        ImGui::SetCursorPos(ImVec2(at.x, at.y + std::ceil(em(1.2F))));
        ImGui::PopID();
    }
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

/// Draws a button that lets theta and phi change places.
void draw_swap(const Row& row) {
    if (!ImGui::SmallButton(std::string(angles_swapped).c_str())) return;
    row.statement.text += "; " + std::string(angles_swapped);
    row.state.wishes.reload = row.statement.id;
}

/// Draws the notes on unusual readings, each on its own lines.
void draw_notes(const Row& row, float width) {
    ImGui::PushStyleColor(ImGuiCol_Text, row.colors.accent);
    ImGui::PushFont(font(FontRole::Small));
    const float left = ImGui::GetCursorPosX();
    ImGui::PushTextWrapPos(left + width);
    std::size_t count = 0;
    for (const Reading& reading : row.report->readings) {
        for (const std::string& note : reading.notes) {
            if (++count > most_notes) break;
            ImGui::SetCursorPosX(left);
            ImGui::TextUnformatted(note.c_str());
            if (note.contains(angles_swapped)) draw_swap(row);
        }
    }
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImGui::PopStyleColor();
}

/// Draws a button that puts a likely word in the place of the one that is not known.
void draw_mend(const Row& row, const RowError& error) {
    const std::string label = error.mend->word + " \xE2\x86\x92 " + error.mend->by;
    ImGui::PushFont(font(FontRole::SmallFormula));
    const bool wanted = ImGui::Button((label + "###mend").c_str());
    ImGui::PopFont();
    draw_tooltip(filled(tr("Put {0} in its place"), {error.mend->by}));
    if (!wanted) return;
    row.statement.text.replace(error.at, error.mend->word.size(), error.mend->by);
    row.state.wishes.reload = row.statement.id;
    row.state.wishes.focus = RowFocus{.row = row.statement.id, .caret = RowFocus::Caret::End};
}

void draw_error(const Row& row, const RowError& error, float width) {
    const bool quiet = error.unfinished;
    ImGui::PushStyleColor(ImGuiCol_Text, quiet ? row.colors.quiet : row.colors.error);
    ImGui::PushFont(font(FontRole::Small));
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    const ImVec2 at = ImGui::GetCursorPos();
    ImGui::TextUnformatted(error.reason.c_str());
    const float height = ImGui::GetItemRectSize().y;
    draw_tooltip(tr("Click: go to the place"));
    if (ImGui::IsItemClicked()) go_to_error(row.state, row.statement.id);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImGui::PopStyleColor();
    if (!error.mend) return;
    ImGui::SetCursorPos(ImVec2(at.x, at.y + height + em(0.3F)));
    draw_mend(row, error);
}

std::string without_blanks(std::string text) {
    std::erase_if(text, [](char letter) { return letter == ' ' || letter == '\n'; });
    return text;
}

/// True if a reading says more than the text; a row that was read as written needs no reading
/// shown.
bool says_more(const Row& row) {
    const auto& readings = row.report->readings;
    return readings.size() > 1 || (readings.size() == 1 && without_blanks(readings.front().text) !=
                                                               without_blanks(row.statement.text));
}

/// Draws the readings or the error below the field.
void draw_answer(const Row& row, float width) {
    if (const RowError* error = row.error()) {
        draw_error(row, *error, width);
    } else if (row.report != nullptr && !row.statement.text.empty()) {
        const float left = ImGui::GetCursorPosX();
        if (says_more(row)) draw_readings(row, width);
        ImGui::SetCursorPosX(left);
        draw_notes(row, width);
    }
}

void draw_back(const Row& row, ImDrawList& canvas, const ImRect& place) {
    const float rounding = em(0.4F);
    if (row.typing || row.hovered) {
        const std::uint32_t color = row.typing ? row.colors.row_active : row.colors.row_hovered;
        canvas.AddRectFilled(place.Min, place.Max, color, rounding);
    }
    if (!row.typing) return;
    canvas.AddRectFilled(place.Min, ImVec2(place.Min.x + em(0.2F), place.Max.y), row.colors.accent,
                         rounding, ImDrawFlags_RoundCornersLeft);
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
    draw_answer(row, right - field - indent - spacing);
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
