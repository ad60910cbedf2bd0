// Builds vectors and lists, and functions of numbers over them: all of it is elaborated away, a
// vector is a few nodes.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/elaborator.hpp"
#include "engine/language/words/words.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

constexpr std::string_view part_names = "xyzw";

}  // namespace

std::string Elaborator::described(const Value& value) {
    const std::string size = std::to_string(value.size());
    if (value.is_vector()) return filled(tr("a vector of {0} numbers"), {size});
    return value.is_list() ? filled(tr("a list of {0}"), {size}) : tr("a number");
}

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
    return bundle(Value::Kind::Vector, std::move(values));
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
    return bundle(Value::Kind::List, std::move(*values));
}

/// Builds p.x, or p.xz for several parts.
Elaborator::Built Elaborator::part(const Syntax& syntax, const Binding* scope) {
    const Built of = build(syntax.operands[0], scope);
    return of ? part_of(*of, syntax.text, syntax) : std::nullopt;
}

Elaborator::Built Elaborator::part_of(const Value& of, std::string_view letters,
                                      const Syntax& syntax) {
    if (of.is_list()) {
        Values parts;
        for (const Value& element : *of.parts) {
            const Built one = part_of(element, letters, syntax);
            if (!one) return std::nullopt;
            parts.push_back(*one);
        }
        return bundle(Value::Kind::List, std::move(parts));
    }
    if (of.is_single()) {
        wants_vector_ = true;
        const Syntax& left = tree_[syntax.operands[0]];
        const bool is_letter = left.kind == SyntaxKind::Name && is_parameter_name(left.text);
        return fail(syntax.offset,
                    filled(tr("only a vector has a part {0}, and this is a number"),
                           {"." + std::string(letters)}),
                    is_letter
                        ? filled(tr("type {0} in a row of its own"), {left.text + " = (x, y, z)"})
                        : filled(tr("type a vector such as {0}"), {"(x, y, z)"}));
    }
    Values parts;
    for (const char letter : letters) {
        const std::size_t index = part_names.find(letter);
        if (index >= of.size()) {
            return fail(syntax.offset, filled(tr("{0} has no part {1}"),
                                              {described(of), "." + std::string(1, letter)}));
        }
        parts.push_back(of.part(index));
    }
    return parts.size() == 1 ? parts.front() : bundle(Value::Kind::Vector, std::move(parts));
}

/// Builds a vector with other numbers in place of some of its parts, as p.xy = ... in the body of
/// a function makes it.
Elaborator::Built Elaborator::replaced(const Syntax& syntax, const Binding* scope) {
    const Built old = build(syntax.operands[0], scope);
    const Built by = old ? operand(syntax.operands[1], scope) : std::nullopt;
    if (!by || !part_of(*old, syntax.text, syntax)) return std::nullopt;
    const bool fits = by->is_single() || (by->is_vector() && by->size() == syntax.text.size());
    if (!fits || !old->is_vector()) {
        const Built parts = part_of(*old, syntax.text, syntax);
        return sizes_differ(*parts, *by, syntax.offset);
    }
    Values parts = *old->parts;
    for (std::size_t i = 0; i < syntax.text.size(); ++i)
        parts[part_names.find(syntax.text[i])] = by->part(i);
    return bundle(Value::Kind::Vector, std::move(parts));
}

/// The error for p[1], which is no product where p is a vector or a list.
std::nullopt_t Elaborator::refuse_index(const Value& of, std::size_t offset) {
    return fail(offset, filled(tr("{0} has no parts by number"), {described(of)}),
                of.is_vector() ? tr("type .x, .y, .z or .w, or several at once: p.xz")
                               : tr("type sum, min or max of it"));
}

Elaborator::Built Elaborator::sizes_differ(const Value& a, const Value& b, std::size_t offset) {
    return fail(offset, filled(tr("{0} does not go with {1}"), {described(a), described(b)}),
                tr("give both the same number of parts"));
}

Elaborator::Built Elaborator::mapped(std::span<const Value> values, std::size_t offset,
                                     const Make& make) {
    const auto widest = std::ranges::max_element(values, {}, &Value::kind);
    if (widest == values.end() || widest->is_single()) {
        std::vector<NodeId> ids;
        for (const Value& value : values)
            ids.push_back(value.id);
        return done(make(ids), offset);
    }
    const Value::Kind kind = widest->kind;
    for (const Value& value : values) {
        if (value.kind == kind && value.size() != widest->size())
            return sizes_differ(*widest, value, offset);
    }
    Values parts;
    for (std::size_t i = 0; i < widest->size(); ++i) {
        Values at;
        for (const Value& value : values)
            at.push_back(value.kind == kind ? value.part(i) : value);
        if (!counts(offset)) return std::nullopt;
        const Built part = mapped(at, offset, make);
        if (!part) return std::nullopt;
        parts.push_back(*part);
    }
    return bundle(kind, std::move(parts));
}

Elaborator::Built Elaborator::combined(const Value& a, const Value& b, std::size_t offset,
                                       Binary make) {
    if (a.is_single() && b.is_single()) return done(make(builder_, a.id, b.id), offset);
    return mapped(std::array{a, b}, offset,
                  [&](std::span<const NodeId> of) { return make(builder_, of[0], of[1]); });
}

/// Joins the parts of a vector or the elements of a list: their sum, product, least or greatest.
Elaborator::Built Elaborator::joined_parts(const Syntax& syntax, const Value& of) {
    const Function& function = *syntax.function;
    const auto join = [&](NodeId a, NodeId b) {
        if (function.composed == Composed::Sum) return make_add(builder_, a, b);
        if (function.composed == Composed::Product) return make_multiply(builder_, a, b);
        return make_function(builder_, function, std::array{a, b});
    };
    Built total = of.part(0);
    for (std::size_t i = 1; total && i < of.size(); ++i) {
        const std::array<Value, 2> both{*total, of.part(i)};
        total = mapped(both, syntax.offset,
                       [&](std::span<const NodeId> ids) { return join(ids[0], ids[1]); });
    }
    return total;
}

/// Adds the numbers of a value, part by part. False if an element of a list is a vector.
bool Elaborator::numbers_of(const Value& value, std::size_t offset, std::vector<NodeId>& numbers) {
    for (std::size_t i = 0; i < value.size(); ++i) {
        const Number number = number_of(value.part(i), offset);
        if (!number || !counts(offset)) return false;
        numbers.push_back(*number);
    }
    return true;
}

/// The length of a vector, or of one with all the given parts; of each vector in a list.
Elaborator::Built Elaborator::length(const Function& function, const Values& values,
                                     std::size_t offset) {
    const bool of_vectors =
        values.size() == 1 && values[0].is_list() && values[0].part(0).is_vector();
    if (of_vectors) {
        Values lengths;
        for (const Value& vector : *values[0].parts) {
            const Built one = length(function, {vector}, offset);
            if (!one) return std::nullopt;
            lengths.push_back(*one);
        }
        return bundle(Value::Kind::List, std::move(lengths));
    }
    std::vector<NodeId> numbers;
    for (const Value& value : values) {
        if (!numbers_of(value, offset, numbers)) return std::nullopt;
    }
    return done(make_function(builder_, function, numbers), offset);
}

/// Builds vec2, vec3 or vec4 of numbers and vectors, as GLSL does: one number stands for all.
Elaborator::Built Elaborator::made_vector(const Syntax& syntax, const Values& values) {
    const std::string name(syntax.function->name);
    const auto size = static_cast<std::size_t>(name.back() - '0');
    std::vector<NodeId> numbers;
    for (const Value& value : values) {
        if (!numbers_of(value, syntax.offset, numbers)) return std::nullopt;
    }
    if (numbers.size() == 1) numbers.assign(size, numbers.front());
    const bool shortens = values.size() == 1 && numbers.size() > size;
    if (shortens) numbers.resize(size);
    if (numbers.size() != size) {
        return fail(syntax.offset,
                    filled(tr("{0} takes {1} numbers, not {2}"),
                           {name, std::to_string(size), std::to_string(numbers.size())}));
    }
    Values parts;
    for (const NodeId id : numbers)
        parts.push_back({.id = id});
    return bundle(Value::Kind::Vector, std::move(parts));
}

}  // namespace zeroset
