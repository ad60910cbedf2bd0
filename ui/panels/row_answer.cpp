#include "ui/panels/row_answer.hpp"

#include "engine/base/translation.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/label.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset::ui {
namespace {

/// Largest numbers of readings and notes that are shown for one row.
constexpr std::size_t most_readings = 4;
constexpr std::size_t most_notes = 4;
/// The statement that a note proposes by which theta and phi change places.
constexpr std::string_view angles_swapped = "swap theta, phi";
/// Opacity of a reading of an older text, while the new one is not read yet.
constexpr double old_reading_faded = 0.5;

/// Whether the reading of the row is shown as a whole: a click on it changes that.
bool& is_unfolded(const Row& row) {
    ImGui::PushID(row.statement.id);
    bool& unfolded = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("##unfolded"));
    ImGui::PopID();
    return unfolded;
}

/// Draws a reading in one line, or as a whole.
void draw_reading(const std::string& text, float width, bool& unfolded) {
    const ImVec2 at = ImGui::GetCursorPos();
    if (unfolded) {
        ImGui::PushTextWrapPos(at.x + width);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopTextWrapPos();
    } else {
        draw_elided(in_one_line(text), width);
    }
    const float height = ImGui::GetItemRectSize().y;
    draw_tooltip(unfolded ? tr("Click: fold the reading") : tr("Click: all of the reading"));
    if (ImGui::IsItemClicked()) unfolded = !unfolded;
    ImGui::SetCursorPos(ImVec2(at.x, at.y + std::max(height, std::ceil(em(1.2F)))));
}

void draw_readings(const Row& row, float width) {
    ImGui::PushFont(font(FontRole::SmallFormula));
    const bool old =
        row.state.shown.picture.dimmed > 0.0F && row.report->text != row.statement.text;
    const double dimmed = old ? static_cast<double>(row.state.shown.picture.dimmed) : 0.0;
    ImGui::PushStyleColor(ImGuiCol_Text, faded(row.colors.quiet, 1.0 - old_reading_faded * dimmed));
    bool& unfolded = is_unfolded(row);
    const auto& readings = row.report->readings;
    const std::size_t most = unfolded ? readings.size() : std::min(readings.size(), most_readings);
    for (std::size_t i = 0; i < most; ++i) {
        ImGui::PushID(static_cast<int>(i));
        draw_reading(readings[i].text, width, unfolded);
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
    std::vector<std::string> notes;
    for (const Reading& reading : row.report->readings)
        notes.insert(notes.end(), reading.notes.begin(), reading.notes.end());
    bool& unfolded = is_unfolded(row);
    const bool all = unfolded || notes.size() <= most_notes;
    const std::size_t shown = all ? notes.size() : most_notes - 1;
    for (std::size_t i = 0; i < shown; ++i) {
        ImGui::SetCursorPosX(left);
        ImGui::TextUnformatted(notes[i].c_str());
        if (notes[i].contains(angles_swapped)) draw_swap(row);
    }
    if (shown < notes.size()) {
        ImGui::SetCursorPosX(left);
        ImGui::TextUnformatted(
            filled(tr("{0} more notes"), {std::to_string(notes.size() - shown)}).c_str());
        draw_tooltip(tr("Click: all of the reading"));
        if (ImGui::IsItemClicked()) unfolded = true;
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
    ImGui::PushStyleColor(ImGuiCol_Text, row.is_broken() ? row.colors.error : row.colors.quiet);
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

}  // namespace

void draw_row_answer(const Row& row, float width) {
    if (const RowError* error = row.error()) {
        draw_error(row, *error, width);
    } else if (row.report != nullptr && !row.statement.text.empty()) {
        const float left = ImGui::GetCursorPosX();
        if (says_more(row)) draw_readings(row, width);
        ImGui::SetCursorPosX(left);
        draw_notes(row, width);
    }
}

}  // namespace zeroset::ui
