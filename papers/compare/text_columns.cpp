#include "papers/compare/text_columns.hpp"

#include <nlohmann/json.hpp>

namespace zeroset {
namespace {

/// `text_of(column)` of all columns in their widths.
template <class TextOf>
std::string line_of(std::span<const TextColumn> columns, const TextOf& text_of) {
    std::string line;
    for (const TextColumn& column : columns) {
        if (!line.empty()) line += ' ';
        line += formatted("%*s", column.width, text_of(column).c_str());
    }
    return line + "\n";
}

}  // namespace

std::string title_line(std::span<const TextColumn> columns) {
    return line_of(columns, [](const TextColumn& column) { return column.title; });
}

std::string row_line(std::span<const TextColumn> columns, const nlohmann::ordered_json& row) {
    return line_of(columns, [&](const TextColumn& column) -> std::string {
        const auto& value = row.at(nlohmann::ordered_json::json_pointer(column.place));
        if (value.is_null()) return "-";
        if (value.is_string()) return value.get<std::string>();
        return formatted("%.*f", column.digits, value.get<double>());
    });
}

}  // namespace zeroset
