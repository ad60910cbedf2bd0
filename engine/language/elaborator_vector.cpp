// Builds vectors and lists, and functions of numbers over them: all of it is elaborated away, a
// vector is a few nodes.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/elaborator.hpp"
#include "engine/language/words/words.hpp"

#include <algorithm>
#include <array>

namespace zeroset {

/// Adds a note on what the text says; the bodies of built-in functions need none.
void Elaborator::note(std::size_t offset, std::string text) {
    if (!library_offset_) notes_.add(offset, std::move(text));
}

Elaborator::Built Elaborator::operand(SyntaxId id, const Binding* scope) {
    Built value = build(id, scope);
    if (!value || !value->condition) return value;
    const Number number = number_of(*value, tree_[id].offset);
    if (!number) return std::nullopt;
    return Value{.id = *number};
}

std::optional<Elaborator::Values> Elaborator::operands(std::span<const SyntaxId> ids,
                                                       const Binding* scope) {
    Values values;
    for (const SyntaxId id : ids) {
        const Built value = operand(id, scope);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

/// Builds (a, b), (a, b, c) or (a, b, c, d).
Elaborator::Built Elaborator::vector(const Syntax& syntax, const Binding* scope) {
    const auto parts = numbers(syntax.operands, scope);
    if (!parts) return std::nullopt;
    Values values;
    for (const NodeId id : *parts)
        values.push_back({.id = id});
    return Value::vector(std::move(values));
}

/// Builds [a, b, ...].
Elaborator::Built Elaborator::list(const Syntax& syntax, const Binding* scope) {
    auto values = operands(syntax.operands, scope);
    if (!values) return std::nullopt;
    for (std::size_t i = 0; i < values->size(); ++i) {
        if ((*values)[i].is_list())
            return fail(tree_[syntax.operands[i]].offset, tr("a list cannot hold a list"),
                        tr("type one list of numbers or of vectors"));
    }
    return Value::list(std::move(*values));
}

/// The hint for a number whose parts are asked for.
std::string Elaborator::hint_for_vector(const Syntax& part) const {
    const Syntax& left = tree_[part.operands[0]];
    const bool is_letter = left.kind == SyntaxKind::Name && is_parameter_name(left.text);
    if (is_letter) return filled(tr("type {0} in a row of its own"), {left.text + " = (x, y, z)"});
    return filled(tr("type a vector such as {0}"), {"(x, y, z)"});
}

/// Builds p.x, or p.xz for several parts.
Elaborator::Built Elaborator::part(const Syntax& syntax, const Binding* scope) {
    const Built of = build(syntax.operands[0], scope);
    return of ? values_.part_of(*of, syntax.text, at(syntax.offset), hint_for_vector(syntax))
              : std::nullopt;
}

/// Builds a vector with other numbers in place of some of its parts, as p.xy = ... in the body of
/// a function makes it.
Elaborator::Built Elaborator::replaced(const Syntax& syntax, const Binding* scope) {
    const Built old = build(syntax.operands[0], scope);
    const Built by = old ? operand(syntax.operands[1], scope) : std::nullopt;
    const std::size_t offset = at(syntax.offset);
    if (!by || !values_.part_of(*old, syntax.text, offset, hint_for_vector(syntax)))
        return std::nullopt;
    return values_.with_parts(*old, syntax.text, *by, offset);
}

}  // namespace zeroset
