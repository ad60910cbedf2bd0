#include "document/sheet.hpp"

#include "document/document.hpp"

#include <algorithm>
#include <expected>
#include <memory>
#include <span>
#include <utility>

namespace zeroset {
namespace {

/// Appended to a text without a surface, so that it can be read.
constexpr std::string_view stand_in = "\n;\nz = 0";
/// Limit of the attempts to read a sheet: each row is tried as typed, as it was last good, and
/// empty.
constexpr std::size_t most_trials = 64;

/// The program of the rows, and whether its surfaces are theirs or the stand-in's.
struct TriedRows {
    JoinedRows joined;
    std::vector<CutText> cuts;
    Program program;
    bool has_surface = true;
};

std::expected<TriedRows, ParseError> try_rows(const std::vector<std::string>& rows,
                                              std::span<const std::optional<Box>> boxes,
                                              const FieldSource* files) {
    JoinedRows joined(rows);
    std::vector<CutText> cuts = joined.cuts(boxes);
    auto program = read_program(joined.text, files, cuts);
    if (program) {
        return TriedRows{
            .joined = std::move(joined), .cuts = std::move(cuts), .program = std::move(*program)};
    }
    const ParseError error = program.error();
    joined.text += stand_in;
    program = read_program(joined.text, files);
    if (program) {
        return TriedRows{.joined = std::move(joined),
                         .cuts = {},
                         .program = std::move(*program),
                         .has_surface = false};
    }
    return std::unexpected(error);
}

RowError row_error(const ParseError& error, std::size_t begin, const std::string& row,
                   const FieldSource* files) {
    const auto of = [&](const ParseError& found, std::size_t offset) {
        const std::string hint = found.hint.empty() ? "" : "; " + found.hint;
        RowError result{.reason = found.reason + hint,
                        .at = std::min(offset, row.size()),
                        .unfinished = found.unfinished};
        const bool is_there =
            found.mend && std::string_view(row).substr(result.at).starts_with(found.mend->word);
        if (is_there) result.mend = found.mend;
        return result;
    };
    const std::size_t at = error.offset - std::min(begin, error.offset);
    if (at >= row.size()) {
        // The error is where the next row begins. It is this row's if that, alone, stops too early.
        const auto alone = read_program(JoinedRows({row}).text, files);
        if (!alone && alone.error().offset >= row.size()) return of(alone.error(), row.size());
    }
    return of(error, at);
}

std::vector<std::optional<Box>> boxes_of(const Sheet& sheet) {
    std::vector<std::optional<Box>> boxes;
    boxes.reserve(sheet.size());
    for (const SheetRow& row : sheet)
        boxes.push_back(row.box);
    return boxes;
}

std::vector<std::string> texts_of(const Sheet& sheet) {
    std::vector<std::string> texts;
    for (const SheetRow& row : sheet)
        texts.push_back(row.text);
    return texts;
}

/// Stores the readings by row, the row of each surface, and the program.
void report_readings(const Sheet& sheet, TriedRows rows, SheetReading& result) {
    for (Reading& reading : std::exchange(rows.program.readings, {})) {
        const bool is_stand_in = !rows.has_surface && reading.kind == StatementKind::Surface;
        const std::size_t row = rows.joined.row_at(reading.offset);
        const int id = is_stand_in ? 0 : sheet[row].id;
        if (reading.kind == StatementKind::Surface) {
            result.surface_rows.push_back(id);
            result.surface_texts.push_back(reading.text);
        }
        if (is_stand_in) continue;
        reading.offset -= rows.joined.begins[row];
        result.reports[id].readings.push_back(std::move(reading));
    }
    result.text = text_with_cuts(std::move(rows.joined.text), rows.cuts);
    result.program = std::make_shared<const Program>(std::move(rows.program));
}

}  // namespace

Sheet sheet_of(const Document& document) {
    Sheet sheet;
    for (const Statement& statement : document.statements)
        sheet.push_back({.id = statement.id, .text = statement.text, .box = statement.box});
    return sheet;
}

/// Keeps the texts that are the rows' own.
void SheetReader::keep_good(const Sheet& sheet, const std::vector<std::string>& texts,
                            const std::vector<int>& surface_rows) {
    for (std::size_t i = 0; i < sheet.size(); ++i) {
        const int id = sheet[i].id;
        if (texts[i] != sheet[i].text) continue;
        good_[id] = {.text = texts[i],
                     .draws = std::ranges::find(surface_rows, id) != surface_rows.end()};
    }
}

SheetReading SheetReader::read(const Sheet& sheet, const std::shared_ptr<const FieldSource>& files,
                               bool draws_old) {
    SheetReading result;
    result.files = files;
    for (const SheetRow& row : sheet)
        result.reports[row.id].text = row.text;
    std::vector<std::string> texts = texts_of(sheet);
    const std::vector<std::optional<Box>> boxes = boxes_of(sheet);
    for (std::size_t trial = 0; trial < most_trials; ++trial) {
        auto rows = try_rows(texts, boxes, files.get());
        if (rows) {
            report_readings(sheet, std::move(*rows), result);
            keep_good(sheet, texts, result.surface_rows);
            return result;
        }
        if (sheet.empty()) break;
        const JoinedRows joined(texts);
        const std::size_t at = joined.row_at(rows.error().offset);
        RowReport& report = result.reports[sheet[at].id];
        const bool first = !report.error;
        if (first)
            report.error = row_error(rows.error(), joined.begins[at], texts[at], files.get());
        // Try the row's last good text next, or nothing where that fails or is the same.
        if (!draws_old)
            std::erase_if(good_, [id = sheet[at].id](const auto& entry) {
                return entry.first == id && entry.second.draws;
            });
        const auto good = good_.find(sheet[at].id);
        const bool stands_in = first && good != good_.end() && good->second.text != texts[at];
        texts[at] = stands_in ? good->second.text : std::string();
    }
    report_readings(sheet, *try_rows({}, {}, nullptr), result);
    return result;
}

}  // namespace zeroset
