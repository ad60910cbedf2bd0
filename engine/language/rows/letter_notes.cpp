#include "engine/language/rows/letter_notes.hpp"

#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

/// The number of uses of a name in all statements, and where the first one is.
std::pair<std::size_t, std::size_t> uses_of(ExpressionReader& reader, std::string_view name) {
    std::size_t count = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < reader.tree().statements.size(); ++i) {
        for (const NameUse& use : reader.table().uses(i)) {
            const Syntax& syntax = reader.tree()[use.at];
            if (syntax.text != name || reader.table().meant(use, i) != nullptr) continue;
            if (count++ == 0) first = syntax.offset;
        }
    }
    return {count, first};
}

}  // namespace

void note_level(ExpressionReader& reader, std::size_t statement, NodeId root) {
    const StatementSyntax& row = reader.tree().statements[statement];
    const Syntax& relation = reader.tree()[row.relation];
    if (relation.kind != SyntaxKind::Compare || relation.marks != "=") return;
    const Syntax& left = reader.tree()[relation.operands[0]];
    const bool is_letter = left.kind == SyntaxKind::Name && reader.names().has_parameter(left.text);
    if (!is_letter || uses_of(reader, left.text).first > 1) return;
    const Expr f = reader.values().builder().finish(root, reader.names().parameters());
    if (f.uses_variable(2) || !(f.uses_variable(0) && f.uses_variable(1))) return;
    reader.values().note(
        row.offset, filled(tr("{0} is a parameter, and this where the right side has its value; "
                              "for the graph of that type {1}"),
                           {left.text, "z = ..."}));
}

void note_euler(ExpressionReader& reader) {
    const FreeNames& names = reader.names();
    const bool is_among =
        std::ranges::all_of(std::array{"a", "b", "c", "d", "f"},
                            [&](const char* name) { return names.has_parameter(name); });
    const auto [count, first] =
        is_among ? uses_of(reader, "e") : std::pair<std::size_t, std::size_t>{};
    if (count == 0) return;
    reader.values().note(
        first,
        filled(tr("{0} is {1}, and no parameter; for one type another letter"), {"e", "2.718..."}));
}

}  // namespace zeroset
