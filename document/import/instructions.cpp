#include "document/import/readers.hpp"
#include "document/row_program.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>

// Lists of instructions of Fidget and libfive: "NAME OPERATION OPERANDS" a line, the last one is
// the function. The language reads them as they stand.

namespace zeroset {
namespace {

/// Whether the text could be the name of a value or an operation.
bool is_word(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
               (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
    });
}

}  // namespace

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
    if (!is_word(words[0]) || !is_word(words[1]))
        return import_error(first, tr("it is no list of instructions, such as \"_0 var-x\""));
    list.add_row(row, first);
    Imported imported;
    imported.documents.push_back(std::move(list));
    return imported;
}

ReadImport read_formulas(std::string_view text, const ImportFiles& files) {
    if (trimmed(text).empty()) return import_error(0, tr("it is empty"));
    ImportedDocument formulas{.name = {}};
    for (const std::string& row : rows_of(text, files.fields))
        formulas.add_row(row, 0);
    Imported imported;
    imported.documents.push_back(std::move(formulas));
    return imported;
}

}  // namespace zeroset
