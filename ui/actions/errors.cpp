#include "ui/actions/action_functions.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace zeroset::ui {
const RowError* error_of(const UiState& state, const Statement& statement) {
    const auto report = state.shown.reading.reports.find(statement.id);
    if (report == state.shown.reading.reports.end()) return nullptr;
    if (report->second.text != statement.text || !report->second.error) return nullptr;
    return &*report->second.error;
}

bool has_errors(const UiState& state) {
    return std::ranges::any_of(state.edited.document.statements, [&](const Statement& statement) {
        return error_of(state, statement) != nullptr;
    });
}

void go_to_error(UiState& state, int row) {
    const std::vector<Statement>& rows = state.edited.document.statements;
    const auto found = std::ranges::find(rows, row, &Statement::id);
    if (found == rows.end()) return;
    const RowError* const error = error_of(state, *found);
    if (error == nullptr) return;
    state.wishes.focus = RowFocus{.row = row, .caret = RowFocus::Caret::At, .at = error->at};
}

void go_to_next_error(UiState& state) {
    const std::vector<Statement>& rows = state.edited.document.statements;
    const auto typed = std::ranges::find(rows, state.input.typing_row, &Statement::id);
    const auto first =
        typed == rows.end() ? std::size_t{0} : static_cast<std::size_t>(typed - rows.begin()) + 1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Statement& statement = rows[(first + i) % rows.size()];
        if (error_of(state, statement) != nullptr) return go_to_error(state, statement.id);
    }
}

}  // namespace zeroset::ui
