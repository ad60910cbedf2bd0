// Vectors and lists, and functions of numbers over them: all of it is elaborated away, a vector is
// a few nodes.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/values/graph_values.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace zeroset {
namespace {

constexpr std::string_view part_names = "xyzw";

}  // namespace

GraphValues::Built GraphValues::sizes_differ(const BuiltValue& a, const BuiltValue& b,
                                             std::size_t offset) {
    return fail(offset, filled(tr("{0} does not go with {1}"), {a.described(), b.described()}),
                tr("give both the same number of parts"));
}

GraphValues::Built GraphValues::mapped(std::span<const BuiltValue> values, std::size_t offset,
                                       const Make& make) {
    const auto widest = std::ranges::max_element(values, {}, &BuiltValue::kind);
    if (widest == values.end() || widest->is_single()) {
        std::vector<NodeId> ids;
        for (const BuiltValue& value : values)
            ids.push_back(value.id);
        return done(make(ids), offset);
    }
    const BuiltValue::Kind kind = widest->kind;
    for (const BuiltValue& value : values) {
        if (value.kind == kind && value.size() != widest->size())
            return sizes_differ(*widest, value, offset);
    }
    BuiltValues parts;
    for (std::size_t i = 0; i < widest->size(); ++i) {
        BuiltValues at;
        for (const BuiltValue& value : values)
            at.push_back(value.kind == kind ? value.part(i) : value);
        if (!counts(offset)) return std::nullopt;
        const Built part = mapped(at, offset, make);
        if (!part) return std::nullopt;
        parts.push_back(*part);
    }
    return BuiltValue::of_parts(kind, std::move(parts));
}

GraphValues::Built GraphValues::combined(const BuiltValue& a, const BuiltValue& b,
                                         std::size_t offset, Binary make) {
    if (a.is_single() && b.is_single()) return done(make(builder_, a.id, b.id), offset);
    if (a.is_complex() || b.is_complex()) return complex_combined(a, b, offset, make);
    return mapped(std::array{a, b}, offset,
                  [&](std::span<const NodeId> of) { return make(builder_, of[0], of[1]); });
}

GraphValues::Built GraphValues::joined_parts(const Function& function, const BuiltValue& of,
                                             std::size_t offset) {
    const auto join = [&](NodeId a, NodeId b) {
        if (function.composed == Composed::Sum) return make_add(builder_, a, b);
        if (function.composed == Composed::Product) return make_multiply(builder_, a, b);
        return make_function(builder_, function, std::array{a, b});
    };
    Built total = of.part(0);
    for (std::size_t i = 1; total && i < of.size(); ++i) {
        const std::array both{*total, of.part(i)};
        total =
            mapped(both, offset, [&](std::span<const NodeId> ids) { return join(ids[0], ids[1]); });
    }
    return total;
}

/// Adds the numbers of a value, part by part. False if an element of a list is a vector.
bool GraphValues::numbers_of(const BuiltValue& value, std::size_t offset,
                             std::vector<NodeId>& numbers) {
    for (std::size_t i = 0; i < value.size(); ++i) {
        const Number number = number_of(value.part(i), offset);
        if (!number || !counts(offset)) return false;
        numbers.push_back(*number);
    }
    return true;
}

GraphValues::Built GraphValues::length(const Function& function, const BuiltValues& values,
                                       std::size_t offset) {
    const bool of_vectors =
        values.size() == 1 && values[0].is_list() && values[0].part(0).is_vector();
    if (of_vectors) {
        BuiltValues lengths;
        for (const BuiltValue& vector : *values[0].parts) {
            const Built one = length(function, {vector}, offset);
            if (!one) return std::nullopt;
            lengths.push_back(*one);
        }
        return BuiltValue::list(std::move(lengths));
    }
    std::vector<NodeId> numbers;
    for (const BuiltValue& value : values) {
        if (!numbers_of(value, offset, numbers)) return std::nullopt;
    }
    return done(make_function(builder_, function, numbers), offset);
}

GraphValues::Built GraphValues::made_vector(const Function& function, const BuiltValues& values,
                                            std::size_t offset) {
    const std::string name(function.name);
    const auto size = static_cast<std::size_t>(name.back() - '0');
    std::vector<NodeId> numbers;
    for (const BuiltValue& value : values) {
        if (!numbers_of(value, offset, numbers)) return std::nullopt;
    }
    if (numbers.size() == 1) numbers.assign(size, numbers.front());
    const bool shortens = values.size() == 1 && numbers.size() > size;
    if (shortens) numbers.resize(size);
    if (numbers.size() != size) {
        return fail(offset, filled(tr("{0} takes {1} numbers, not {2}"),
                                   {name, std::to_string(size), std::to_string(numbers.size())}));
    }
    BuiltValues parts;
    for (const NodeId id : numbers)
        parts.push_back({.id = id});
    return BuiltValue::vector(std::move(parts));
}

GraphValues::Built GraphValues::part_of(const BuiltValue& of, std::string_view letters,
                                        std::size_t offset, std::string_view name) {
    if (of.is_list()) {
        BuiltValues parts;
        for (const BuiltValue& element : *of.parts) {
            const Built one = part_of(element, letters, offset, name);
            if (!one) return std::nullopt;
            parts.push_back(*one);
        }
        return BuiltValue::list(std::move(parts));
    }
    if (of.is_single()) {
        return fail_for_vector(offset,
                               filled(tr("only a vector has a part {0}, and this is a number"),
                                      {"." + std::string(letters)}),
                               name.empty() ? filled(tr("type a vector such as {0}"), {"(x, y, z)"})
                                            : filled(tr("type {0} in a row of its own"),
                                                     {std::string(name) + " = (x, y, z)"}));
    }
    BuiltValues parts;
    for (const char letter : letters) {
        const std::size_t index = part_names.find(letter);
        if (index >= of.size()) {
            return fail(offset, filled(tr("{0} has no part {1}"),
                                       {of.described(), "." + std::string(1, letter)}));
        }
        parts.push_back(of.part(index));
    }
    return parts.size() == 1 ? parts.front() : BuiltValue::vector(std::move(parts));
}

GraphValues::Built GraphValues::with_parts(const BuiltValue& old, std::string_view letters,
                                           const BuiltValue& by, std::size_t offset) {
    const bool fits = by.is_single() || (by.is_vector() && by.size() == letters.size());
    if (!fits || !old.is_vector()) {
        const Built parts = part_of(old, letters, offset);
        return parts ? sizes_differ(*parts, by, offset) : parts;
    }
    BuiltValues parts = *old.parts;
    for (std::size_t i = 0; i < letters.size(); ++i)
        parts[part_names.find(letters[i])] = by.part(i);
    return BuiltValue::vector(std::move(parts));
}

std::nullopt_t GraphValues::refuse_index(const BuiltValue& of, std::size_t offset) {
    return fail(offset, filled(tr("{0} has no parts by number"), {of.described()}),
                of.is_vector() ? tr("type .x, .y, .z or .w, or several at once: p.xz")
                               : tr("type sum, min or max of it"));
}

}  // namespace zeroset
