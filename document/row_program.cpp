#include "document/row_program.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr std::string_view blank = " \t\r\n;";

std::string_view stripped(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(blank);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blank) + 1 - begin);
}

/// Where a statement begins whose first sign that counts is at `at`: LaTeX has words such as \left
/// and \displaystyle before it, and signs of formulas.
std::size_t with_latex_before(std::string_view text, std::size_t at) {
    for (;;) {
        const std::string_view before = text.substr(0, at);
        const std::size_t end = before.find_last_not_of(" \t") + 1;
        std::size_t begin = end;
        while (begin > 0 && std::isalpha(static_cast<unsigned char>(text[begin - 1])) != 0)
            --begin;
        const std::string_view last = text.substr(begin, end - begin);
        const bool is_word = !last.empty() && begin > 0 && text[begin - 1] == '\\';
        const bool opens = last.empty() && (before.substr(0, end).ends_with("\\(") ||
                                            before.substr(0, end).ends_with("\\["));
        if (is_word)
            at = begin - 1;
        else if (opens)
            at = end - 2;
        else if (end > 0 && text[end - 1] == '$')
            at = end - 1;
        else
            return at;
    }
}

/// Offsets at which the statements of a program begin, in ascending order.
std::vector<std::size_t> statement_begins(const Program& program, std::string_view text) {
    std::vector<std::size_t> begins;
    begins.reserve(program.readings.size());
    for (const Reading& reading : program.readings)
        begins.push_back(with_latex_before(text, reading.offset));
    std::ranges::sort(begins);
    return begins;
}

/// Offsets behind each line end.
std::vector<std::size_t> line_begins(std::string_view text) {
    std::vector<std::size_t> begins;
    for (std::size_t at = text.find('\n'); at != std::string_view::npos;
         at = text.find('\n', at + 1))
        begins.push_back(at + 1);
    return begins;
}

/// A part of a text that becomes a row, and where it was in the text.
struct TextRow {
    std::size_t begin;
    std::string_view text;
};

/// The text cut before each statement; before each line where there is no program.
std::vector<TextRow> cut_rows(std::string_view text, const Program* program) {
    std::vector<std::size_t> begins =
        program ? statement_begins(*program, text) : line_begins(text);
    // Text before the first statement, such as a remark, is a row of its own.
    if (begins.empty() || !stripped(text.substr(0, begins.front())).empty())
        begins.insert(begins.begin(), 0);
    std::vector<TextRow> rows;
    for (std::size_t i = 0; i < begins.size(); ++i) {
        const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : text.size();
        std::string_view row = stripped(text.substr(begins[i], end - begins[i]));
        // The sign that parted it from the next statement is not needed any more.
        if (program && (row.ends_with(',') || row.ends_with(':')))
            row = stripped(row.substr(0, row.size() - 1));
        if (!row.empty()) rows.push_back({.begin = begins[i], .text = row});
    }
    return rows;
}

Document document_of(const std::vector<TextRow>& rows) {
    Document document;
    for (const TextRow& row : rows)
        document.statements.emplace_back().text = row.text;
    if (document.statements.empty()) document.statements.emplace_back();
    return renumbered(std::move(document), 1);
}

/// The program of a document's rows; `row_at` finds the index of the row at an offset.
template <class RowAt>
RowProgram row_program(std::string text, Program program, const Document& document,
                       const RowAt& row_at) {
    RowProgram rows{.text = std::move(text), .files = document.files};
    for (const Reading& reading : program.readings) {
        if (reading.kind != StatementKind::Surface) continue;
        rows.surface_rows.push_back(document.statements[row_at(reading.offset)].id);
        rows.surface_texts.push_back(reading.text);
    }
    rows.program = std::make_shared<const Program>(std::move(program));
    return rows;
}

/// The fields that all surfaces of a program ask, surface by surface.
std::vector<std::shared_ptr<const Field>> fields_in(const RowProgram& rows) {
    std::vector<std::shared_ptr<const Field>> fields;
    if (rows.program == nullptr) return fields;
    for (const Expr& surface : rows.program->surfaces)
        std::ranges::copy(fields_of(surface), std::back_inserter(fields));
    return fields;
}

}  // namespace

bool same_functions(const RowProgram& a, const RowProgram& b) {
    return a.text == b.text && fields_in(a) == fields_in(b);
}

std::expected<RowProgram, ParseError> read_rows(const Document& document) {
    const JoinedRows joined = joined_rows(document);
    const std::vector<CutText> cuts = joined.cuts(boxes_of(document));
    auto program = read_program(joined.text, document.files.get(), cuts);
    if (!program) return std::unexpected(program.error());
    const auto row_at = [&joined](std::size_t offset) { return joined.row_at(offset); };
    return row_program(text_with_cuts(joined.text, cuts), std::move(*program), document, row_at);
}

TextDocument read_text(std::string_view text, std::shared_ptr<const FieldSource> files) {
    auto program = read_program(text, files.get());
    const std::vector<TextRow> rows = cut_rows(text, program ? &*program : nullptr);
    Document document = document_of(rows);
    document.files = std::move(files);
    if (!program)
        return {.document = std::move(document), .rows = std::unexpected(program.error())};
    const auto row_at = [&rows](std::size_t offset) {
        const auto after = std::ranges::upper_bound(rows, offset, {}, &TextRow::begin);
        return static_cast<std::size_t>(after - rows.begin()) - 1;
    };
    RowProgram read = row_program(std::string(text), std::move(*program), document, row_at);
    return {.document = std::move(document), .rows = std::move(read)};
}

std::vector<std::string> rows_of(std::string_view text, const FieldSource* files) {
    const auto program = read_program(text, files);
    std::vector<std::string> rows;
    for (const TextRow& row : cut_rows(text, program ? &*program : nullptr))
        rows.emplace_back(row.text);
    return rows;
}

}  // namespace zeroset
