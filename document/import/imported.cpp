#include "document/import/imported.hpp"

#include "document/row_program.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <charconv>
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
    return row;
}

std::unexpected<std::string> import_error(std::size_t line, const std::string& reason) {
    if (line == 0) return std::unexpected(reason);
    return std::unexpected(filled(tr("line {0}: {1}"), {std::to_string(line), reason}));
}

std::uint32_t shown_color(double red, double green, double blue) {
    return channel_of(red) << 16U | channel_of(green) << 8U | channel_of(blue);
}

std::string exact_number(double value, bool inner) {
    std::array<char, 32> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    const std::string text(digits.data(), end);
    return inner && text.starts_with('-') ? "(" + text + ")" : text;
}

void check_rows(ImportedDocument& imported) {
    std::vector<Statement>& rows = imported.document.statements;
    if (rows.empty()) imported.add_row("", 0);
    const std::vector<Statement> as_written = rows;
    std::vector<ImportNote> refused;
    for (std::size_t round = 0; round <= as_written.size(); ++round) {
        const auto program = read_rows(imported.document);
        if (program) {
            for (ImportNote& note : refused)
                imported.note(note.line, note.entry, std::move(note.reason));
            return;
        }
        const JoinedRows joined = joined_rows(imported.document);
        const std::size_t at = joined.row_at(program.error().offset);
        const bool is_new = at < rows.size() && rows[at].text == as_written[at].text &&
                            !rows[at].text.empty();
        if (!is_new) break;
        refused.push_back({.line = imported.row_lines[at],
                           .entry = std::string(line_at(rows[at].text, 0).substr(0, 60)),
                           .reason = filled(tr("the row is a remark: {0}"),
                                            {reason_of(program.error())})});
        rows[at].text = as_remark(rows[at].text);
    }
    rows = as_written;
    const auto program = read_rows(imported.document);
    if (!program) imported.refusal = reason_of(program.error());
}

}  // namespace zeroset
