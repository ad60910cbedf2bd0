#include "document/document.hpp"
#include "document/row_program.hpp"
#include "engine/base/translation.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/panels/statement_field.hpp"
#include "ui/panels/statement_row.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset::ui {
namespace {

using Caret = RowFocus::Caret;

constexpr const char* long_hint = marked("type an equation, such as x^2 + y^2 + z^2 = 1");
constexpr const char* short_hint = marked("type an equation");

std::vector<Statement>& rows(UiState& state) { return state.edited.document.statements; }

auto at(UiState& state, std::size_t index) {
    return rows(state).begin() + static_cast<std::ptrdiff_t>(index);
}

/// Gives the keyboard to the row at `index`, or to the last row; the list is never empty.
void focus(UiState& state, std::size_t index, Caret caret) {
    const std::size_t last = rows(state).size() - 1;
    state.wishes.focus = RowFocus{.row = rows(state)[std::min(index, last)].id, .caret = caret};
}

/// Gives the keyboard to the row below, with the caret in its first line.
void focus_down(UiState& state, std::size_t index) {
    const std::size_t below = std::min(index + 1, rows(state).size() - 1);
    const bool lines = below > index && rows(state)[below].text.contains('\n');
    focus(state, below, lines ? Caret::Start : Caret::End);
}

void insert_row(UiState& state, std::size_t index) {
    Statement statement;
    statement.id = unused_id(state.edited.document);
    rows(state).insert(at(state, index), statement);
    focus(state, index, Caret::End);
}

void remove_row(UiState& state, std::size_t index, bool back) {
    const bool typing = state.input.typing_row == rows(state)[index].id;
    if (rows(state).size() == 1) {
        rows(state)[0] = Statement{
            .id = unused_id(state.edited.document), .text = {}, .visible = true, .color = {}};
    } else {
        rows(state).erase(at(state, index));
    }
    if (typing)
        focus(state, back && index > 0 ? index - 1 : index, back ? Caret::End : Caret::Start);
}

void duplicate_row(UiState& state, std::size_t index) {
    Statement copy = rows(state)[index];
    copy.id = unused_id(state.edited.document);
    copy.color.reset();
    rows(state).insert(at(state, index + 1), std::move(copy));
    focus(state, index + 1, Caret::End);
}

void move_row(UiState& state, std::size_t index, std::ptrdiff_t by) {
    const int id = rows(state)[index].id;
    if (state.input.typing_row == id) state.wishes.focus = RowFocus{.row = id, .caret = Caret::End};
    const auto other = static_cast<std::ptrdiff_t>(index) + by;
    if (other < 0 || other >= std::ssize(rows(state))) return;
    std::iter_swap(at(state, index), rows(state).begin() + other);
}

/// Divides a row whose text contains several statements, as after pasting, into one row for each.
void split_row(UiState& state, std::size_t index) {
    const std::vector<std::string> texts =
        rows_of(rows(state)[index].text, state.edited.document.files.get());
    if (texts.size() < 2) {
        focus(state, index, Caret::End);
        return;
    }
    const std::string all = std::exchange(rows(state)[index].text, texts.front());
    insert_rows(state, index, all.substr(all.find(texts.front()) + texts.front().size()));
}

void do_event(UiState& state, std::size_t index, RowEvent event) {
    switch (event) {
        case RowEvent::None: return;
        case RowEvent::Next: return insert_row(state, index + 1);
        case RowEvent::FocusUp: return focus(state, index == 0 ? 0 : index - 1, Caret::End);
        case RowEvent::FocusDown: return focus_down(state, index);
        case RowEvent::FocusNext:
            if (index + 1 < rows(state).size()) focus(state, index + 1, Caret::All);
            return;
        case RowEvent::FocusPrevious:
            if (index > 0) focus(state, index - 1, Caret::All);
            return;
        case RowEvent::RemoveBack: return remove_row(state, index, true);
        case RowEvent::RemoveAhead: return remove_row(state, index, false);
        case RowEvent::MoveUp: return move_row(state, index, -1);
        case RowEvent::MoveDown: return move_row(state, index, 1);
        case RowEvent::Duplicate: return duplicate_row(state, index);
        case RowEvent::Split: return split_row(state, index);
    }
}

/// Draws the button below the last row that adds a row.
void draw_adder(UiState& state) {
    const Palette& colors = palette(state.edited.theme);
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const float height = em(2.0F);
    if (ImGui::InvisibleButton("##add", ImVec2(ImGui::GetContentRegionAvail().x, height))) {
        insert_row(state, rows(state).size());
    }
    draw_focus_ring();
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    const ImVec2 hi = ImGui::GetItemRectMax();
    if (hovered) canvas.AddRectFilled(lo, hi, colors.row_hovered, em(0.4F));
    const std::uint32_t color = hovered ? colors.text : colors.quiet;
    const float middle = 0.5F * (lo.y + hi.y);
    draw_icon(canvas, Icon::Plus, ImVec2(lo.x + em(1.65F), middle), em(0.75F), color);
    canvas.AddText(ImVec2(lo.x + em(3.4F), middle - 0.5F * ImGui::GetFontSize()), color,
                   tr("Add a statement"));
}

/// Returns the hint for an empty field; nullptr if the list has more than one row.
const char* hint_for(const UiState& state) {
    if (state.edited.document.statements.size() > 1) return nullptr;
    const bool wide = ImGui::GetContentRegionAvail().x > em(32.0F);
    return tr(wide ? long_hint : short_hint);
}

}  // namespace

void insert_rows(UiState& state, std::size_t index, const std::string& text) {
    for (const std::string& row : rows_of(text, state.edited.document.files.get())) {
        insert_row(state, ++index);
        rows(state)[index].text = row;
    }
}

void draw_statement_list(UiState& state) {
    state.input.typing_row = 0;
    std::optional<std::pair<std::size_t, RowEvent>> event;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(em(0.3F), em(0.25F)));
    for (std::size_t i = 0; i < rows(state).size(); ++i) {
        const RowEvent happened = draw_statement_row(state, i, hint_for(state));
        if (happened != RowEvent::None) event = {i, happened};
    }
    draw_adder(state);
    draw_parameter_rows(state.edited, state.shown.reading);
    ImGui::PopStyleVar();
    if (event) do_event(state, event->first, event->second);
}

}  // namespace zeroset::ui
