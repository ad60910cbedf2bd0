#include "engine/language/rows/meeting_reader.hpp"

#include "engine/expr/simplify.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace zeroset {

bool MeetingReader::may_read(std::size_t statement) const {
    const SyntaxTree& tree = reader_.tree();
    const Syntax& relation = tree[tree.statements[statement].relation];
    return relation.kind == SyntaxKind::And && relation.operands.size() == 2 &&
           std::ranges::all_of(relation.operands, [&](SyntaxId id) {
               return tree[id].kind == SyntaxKind::Compare && tree[id].marks == "=";
           });
}

RowResult MeetingReader::read(std::size_t statement) {
    GraphValues& values = reader_.values();
    const SyntaxTree& tree = reader_.tree();
    const Syntax& relation = tree[tree.statements[statement].relation];
    const Context context{.statement = statement};
    std::array<NodeId, 2> functions{};
    std::string text;
    for (std::size_t i = 0; i < functions.size(); ++i) {
        const Syntax& equation = tree[relation.operands[i]];
        const auto left = reader_.number(equation.operands[0], context);
        const auto right = left ? reader_.number(equation.operands[1], context) : std::nullopt;
        if (!right) return values.failure();
        functions.at(i) = make_subtract(values.builder(), *left, *right);
        if (!values.done(functions.at(i), equation.offset)) return values.failure();
        if (!values.uses_space(functions.at(i)))
            return std::unexpected(maker_.error_without_place(statement));
        text += (i > 0 ? " and " : "") + text_.of(functions.at(i)) + " = 0";
    }
    const auto condition = equations_.restriction(statement);
    if (!condition) return std::unexpected(condition.error());
    NodeId where = condition->value_or(values.builder().constant(1.0));
    if (*condition) text += ", " + text_.of(where);
    if (const auto inside = maker_.inside_box(statement))
        where = *condition ? make_call(values.builder(), Op::And, where, *inside) : *inside;
    return maker_.patch(statement, PatchKind::Meeting, {functions[0], functions[1], where},
                        std::move(text));
}

}  // namespace zeroset
