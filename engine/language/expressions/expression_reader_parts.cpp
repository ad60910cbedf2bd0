// Builds vectors, lists and conditions.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/expressions/expression_reader.hpp"
#include "engine/language/words/words.hpp"

#include <utility>

namespace zeroset {

/// Builds (a, b), (a, b, c) or (a, b, c, d).
ExpressionReader::Built ExpressionReader::vector(const Syntax& syntax, const Context& context) {
    const auto parts = numbers(syntax.operands, context);
    if (!parts) return std::nullopt;
    BuiltValues values;
    for (const NodeId id : *parts)
        values.push_back({.id = id});
    return BuiltValue::vector(std::move(values));
}

/// Builds [a, b, ...].
ExpressionReader::Built ExpressionReader::list(const Syntax& syntax, const Context& context) {
    auto values = operands(syntax.operands, context);
    if (!values) return std::nullopt;
    for (std::size_t i = 0; i < values->size(); ++i) {
        if ((*values)[i].is_complex())
            return values_.refuse_complex(context.at(tree_[syntax.operands[i]].offset));
        if ((*values)[i].is_list())
            return values_.fail(context.at(tree_[syntax.operands[i]].offset),
                                tr("a list cannot hold a list"),
                                tr("type one list of numbers or of vectors"));
    }
    return BuiltValue::list(std::move(*values));
}

/// The letter whose parts are asked for; empty: it is no letter.
std::string_view ExpressionReader::letter_of(const Syntax& part) const {
    const Syntax& left = tree_[part.operands[0]];
    const bool is_letter = left.kind == SyntaxKind::Name && is_parameter_name(left.text);
    return is_letter ? std::string_view(left.text) : std::string_view();
}

/// Builds p.x, or p.xz for several parts.
ExpressionReader::Built ExpressionReader::part(const Syntax& syntax, const Context& context) {
    const Built of = build(syntax.operands[0], context);
    return of ? values_.part_of(*of, syntax.text, context.at(syntax.offset), letter_of(syntax))
              : std::nullopt;
}

/// Builds a vector with other numbers in place of some of its parts, as p.xy = ... in the body of
/// a function makes it.
ExpressionReader::Built ExpressionReader::replaced(const Syntax& syntax, const Context& context) {
    const Built old = build(syntax.operands[0], context);
    const Built by = old ? operand(syntax.operands[1], context) : std::nullopt;
    const std::size_t offset = context.at(syntax.offset);
    if (!by || !values_.part_of(*old, syntax.text, offset, letter_of(syntax))) return std::nullopt;
    return values_.with_parts(*old, syntax.text, *by, offset);
}

ExpressionReader::Number ExpressionReader::condition(SyntaxId id, const Context& context,
                                                     Numbers numbers) {
    const Built value = build(id, context);
    if (!value) return std::nullopt;
    const std::size_t offset = context.at(tree_[id].offset);
    if (!value->condition && numbers == Numbers::Refused) {
        return values_.fail(offset, tr("a condition is wanted here"),
                            tr("compare, for example z < 1"));
    }
    return values_.condition_of(*value, offset);
}

/// Builds a comparison; a < b < c is a < b and b < c.
ExpressionReader::Built ExpressionReader::compare(const Syntax& syntax, const Context& context) {
    const std::size_t offset = context.at(syntax.offset);
    Built left = build(syntax.operands[0], context);
    Number all;
    for (std::size_t i = 1; left && i < syntax.operands.size(); ++i) {
        const Built right = build(syntax.operands[i], context);
        if (!right) return std::nullopt;
        const Number one = values_.compared(syntax.marks[i - 1], *left, *right, offset);
        if (!one) return std::nullopt;
        all = all ? make_call(values_.builder(), Op::And, *all, *one) : *one;
        if (!values_.done(*all, offset)) return std::nullopt;
        left = right;
    }
    if (!left) return std::nullopt;
    return BuiltValue{.id = *all, .condition = true};
}

ExpressionReader::Built ExpressionReader::connected(const Syntax& syntax, Op op,
                                                    const Context& context) {
    Number all = condition(syntax.operands[0], context, Numbers::TrueUnlessZero);
    for (std::size_t i = 1; all && i < syntax.operands.size(); ++i) {
        const Number further = condition(syntax.operands[i], context, Numbers::TrueUnlessZero);
        if (!further) return std::nullopt;
        all = make_call(values_.builder(), op, *all, *further);
        if (!values_.done(*all, context.at(syntax.offset))) return std::nullopt;
    }
    if (!all) return std::nullopt;
    return BuiltValue{.id = *all, .condition = true};
}

ExpressionReader::Built ExpressionReader::opposite(const Syntax& syntax, const Context& context) {
    const Number holds = condition(syntax.operands[0], context, Numbers::TrueUnlessZero);
    if (!holds) return std::nullopt;
    return values_.done(make_call(values_.builder(), Op::Not, *holds), context.at(syntax.offset),
                        true);
}

ExpressionReader::Built ExpressionReader::cases(const Syntax& syntax, const Context& context) {
    const Numbers numbers = syntax.marks == "?" ? Numbers::TrueUnlessZero : Numbers::Refused;
    Built value;
    std::size_t i = syntax.operands.size();
    if (i % 2 == 1) {
        value = operand(syntax.operands[--i], context);
        if (!value) return std::nullopt;
    }
    for (; i >= 2; i -= 2) {
        const Number where = condition(syntax.operands[i - 2], context, numbers);
        const Built there = where ? operand(syntax.operands[i - 1], context) : std::nullopt;
        if (!there) return std::nullopt;
        BuiltValues all{{.id = *where}, *there};
        if (value) all.push_back(*value);
        values_.make_alike(std::span(all).subspan(1));
        value = values_.mapped(all, context.at(syntax.offset), [&](std::span<const NodeId> of) {
            return of.size() == 3 ? make_call(values_.builder(), Op::If, of[0], of[1], of[2])
                                  : make_call(values_.builder(), Op::Where, of[1], of[0]);
        });
        if (!value) return std::nullopt;
    }
    return value;
}

}  // namespace zeroset
