#include "document/import/imported.hpp"

#include "document/row_program.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zeroset {
namespace {

std::string reason_of(const ParseError& error) {
    return error.hint.empty() ? error.reason : error.reason + "; " + error.hint;
}

/// The row with a # before each of its lines: it is kept, and says nothing.
std::string as_remark(const std::string& text) {
    std::string remark = "# ";
    for (const char letter : text) {
        remark += letter;
        if (letter == '\n') remark += "# ";
    }
    return remark;
}

/// How often a text is read at most, and so many bytes of rows in all: a text of which more rows
/// are refused is no file of formulas.
constexpr std::size_t most_readings = 200;
constexpr std::size_t most_bytes_read = 100'000'000;

std::size_t most_refused(const std::vector<Statement>& rows) {
    std::size_t bytes = 1;
    for (const Statement& row : rows)
        bytes += row.text.starts_with('#') ? 0 : row.text.size() + 1;
    return std::min(most_readings, most_bytes_read / bytes);
}

/// Makes a remark of the row of an error, and adds a note; false where that would not help.
bool refuse_row(ImportedDocument& imported, const ParseError& error,
                const std::vector<Statement>& as_written, std::vector<ImportNote>& refused) {
    std::vector<Statement>& rows = imported.document.statements;
    const std::size_t at = joined_rows(imported.document).row_at(error.offset);
    if (at >= rows.size() || rows[at].text != as_written[at].text || rows[at].text.empty())
        return false;
    refused.push_back({.line = imported.row_lines[at],
                       .entry = std::string(line_at(rows[at].text, 0).substr(0, 60)),
                       .reason = reason_of(error)});
    rows[at].text = as_remark(rows[at].text);
    // Without a surface there is nothing that more remarks could save.
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (imported.row_draws[i] && rows[i].text == as_written[i].text) return true;
    }
    return false;
}

/// Whether a surface of the program is one of the file's; hides the others.
bool draws_something(ImportedDocument& imported, const RowProgram& program) {
    std::vector<Statement>& rows = imported.document.statements;
    bool draws = false;
    for (const int id : program.surface_rows) {
        const auto row = std::ranges::find(rows, id, &Statement::id);
        if (row == rows.end()) continue;
        const bool is_surface = imported.row_draws[static_cast<std::size_t>(row - rows.begin())];
        draws = draws || is_surface;
        if (!is_surface) row->visible = false;
    }
    return draws;
}

std::uint32_t channel_of(double value) {
    const double bounded = std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0;
    return static_cast<std::uint32_t>(std::lround(255.0 * bounded));
}

}  // namespace

void ImportedDocument::note(std::size_t line, std::string_view entry, std::string reason) {
    ImportNote added{.line = line, .entry = std::string(entry), .reason = std::move(reason)};
    if (std::ranges::find(notes, added) == notes.end()) notes.push_back(std::move(added));
}

Statement& ImportedDocument::add_row(std::string text, std::size_t line,
                                     std::optional<std::uint32_t> color) {
    Statement& row = document.statements.emplace_back();
    row.text = std::move(text);
    row.color = color;
    row.id = static_cast<int>(document.statements.size());
    row_lines.push_back(line);
    row_draws.push_back(true);
    return row;
}

void ImportedDocument::add_definition(std::string text, std::size_t line) {
    add_row(std::move(text), line);
    row_draws.back() = false;
}

std::unexpected<std::string> import_error(std::size_t line, const std::string& reason) {
    // A reason may have names of the file in it.
    std::string one_line = reason;
    for (char& letter : one_line)
        letter = static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
    if (line == 0) return std::unexpected(one_line);
    return std::unexpected(filled(tr("line {0}: {1}"), {std::to_string(line), one_line}));
}

std::uint32_t shown_color(double red, double green, double blue) {
    return channel_of(red) << 16U | channel_of(green) << 8U | channel_of(blue);
}

std::string exact_number(double value, bool inner) {
    const std::string text = digits_of(value);
    return inner && text.starts_with('-') ? "(" + text + ")" : text;
}

void check_rows(ImportedDocument& imported) {
    std::vector<Statement>& rows = imported.document.statements;
    if (rows.empty()) imported.add_row("", 0);
    const std::vector<Statement> as_written = rows;
    std::vector<ImportNote> refused;
    auto program = read_rows(imported.document);
    const std::size_t most = most_refused(rows);
    while (!program && refused.size() < most &&
           refuse_row(imported, program.error(), as_written, refused))
        program = read_rows(imported.document);
    if (program && draws_something(imported, *program)) {
        for (ImportNote& note : refused)
            imported.note(note.line, note.entry, std::move(note.reason));
        return;
    }
    rows = as_written;
    const std::string why =
        program ? std::string(tr("it has no surface")) : reason_of(program.error());
    imported.refusal = refused.empty() ? why : refused.front().reason;
    if (most > 0 && refused.size() == most)
        imported.refusal =
            filled(tr("{0} of its rows are refused, and there are more; the first: {1}"),
                   {std::to_string(most), imported.refusal});
}

}  // namespace zeroset
