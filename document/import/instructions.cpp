#include "document/import/readers.hpp"
#include "document/row_program.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>

// Lists of instructions of Fidget and libfive: "NAME OPERATION OPERANDS" a line, the last one is the
// function. The language reads them as they stand.

namespace zeroset {

ReadImport read_instructions(std::string_view text) {
    ImportedDocument list{.name = {}};
    std::string row;
    std::size_t line = 0;
    std::size_t first = 0;
    for (const std::string_view typed : split(text, '\n')) {
        ++line;
        if (first == 0 && typed.starts_with('#')) {
            list.add_definition(std::string(typed), line);
            continue;
        }
        if (typed.empty() || typed.starts_with('#')) continue;
        if (first == 0) first = line;
        row += (row.empty() ? "" : "\n") + std::string(typed);
    }
    const auto words = split(std::string_view(row).substr(0, row.find('\n')), ' ');
    if (words.size() < 2)
        return import_error(0, tr("it is no list of instructions, such as \"_0 var-x\""));
    const bool first_is_plain = std::ranges::none_of(words[0], [](char c) { return c == '=' || c == '('; });
    if (!first_is_plain)
        return import_error(first, tr("it is no list of instructions, such as \"_0 var-x\""));
    list.add_row(row, first);
    Imported imported;
    imported.documents.push_back(std::move(list));
    return imported;
}

ReadImport read_formulas(std::string_view text) {
    if (trimmed(text).empty()) return import_error(0, tr("it is empty"));
    ImportedDocument formulas{.name = {}};
    for (const std::string& row : rows_of(text))
        formulas.add_row(row, 0);
    Imported imported;
    imported.documents.push_back(std::move(formulas));
    return imported;
}

}  // namespace zeroset
