// Complex numbers: pairs of nodes, real again where the imaginary part is 0.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/values/graph_values.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace zeroset {
namespace {

using Operation = ComplexNodes (ComplexFunctions::*)(const ComplexNodes&, const ComplexNodes&);

using OperationRow = std::pair<GraphValues::Binary, Operation>;
constexpr std::array operations{OperationRow(make_add, &ComplexFunctions::sum),
                                OperationRow(make_subtract, &ComplexFunctions::difference),
                                OperationRow(make_multiply, &ComplexFunctions::product),
                                OperationRow(make_divide, &ComplexFunctions::quotient),
                                OperationRow(make_power, &ComplexFunctions::power)};

/// A function composed of others; nothing of one that is none of complex numbers.
std::optional<ComplexNodes> composed(ComplexFunctions& numbers, Composed function,
                                     std::span<const ComplexNodes> of, const ComplexNodes& one) {
    if (function == Composed::Pow) return numbers.power(of[0], of[1]);
    if (function == Composed::LogBase) {
        const ComplexNodes above = numbers.logarithm(of[0]);
        return of.size() == 1 ? above : numbers.quotient(above, numbers.logarithm(of[1]));
    }
    static constexpr std::array<std::pair<Composed, Op>, 5> reciprocals{
        {{Composed::Sec, Op::Cos},
         {Composed::Csc, Op::Sin},
         {Composed::Sech, Op::Cosh},
         {Composed::Csch, Op::Sinh},
         {Composed::Coth, Op::Tanh}}};
    const auto* const found =
        std::ranges::find(reciprocals, function, &std::pair<Composed, Op>::first);
    const auto below =
        found == reciprocals.end() ? std::nullopt : numbers.call(found->second, of[0]);
    return below ? std::optional(numbers.quotient(one, *below)) : std::nullopt;
}

}  // namespace

std::nullopt_t GraphValues::refuse_complex(std::size_t offset) {
    return fail(offset, tr("a real number is wanted here, and this is a complex one"),
                filled(tr("type abs, Re, Im or arg of it, as in {0}"), {"z = Re((x + i y)^2)"}));
}

ComplexNodes GraphValues::nodes_of(const BuiltValue& value) {
    if (value.is_complex()) return {.re = value.part(0).id, .im = value.part(1).id};
    return {.re = value.id, .im = builder_.constant(0.0)};
}

GraphValues::Built GraphValues::complex(const ComplexNodes& number, std::size_t offset) {
    if (!done(number.re, offset) || !done(number.im, offset)) return std::nullopt;
    if (is_zero(number.im)) return BuiltValue{.id = number.re};
    return BuiltValue::complex(number.re, number.im);
}

void GraphValues::make_alike(std::span<BuiltValue> values) {
    if (std::ranges::none_of(values, &BuiltValue::is_complex)) return;
    for (BuiltValue& value : values) {
        if (!value.is_single()) continue;
        const ComplexNodes nodes = nodes_of(value);
        value = BuiltValue::complex(nodes.re, nodes.im);
    }
}

GraphValues::Built GraphValues::complex_combined(const BuiltValue& a, const BuiltValue& b,
                                                 std::size_t offset, Binary make) {
    const BuiltValue& other = a.is_complex() ? b : a;
    if (other.is_vector() || other.is_list()) {
        return fail(offset, filled(tr("{0} does not go with {1}"), {a.described(), b.described()}),
                    tr("complex numbers go with numbers only"));
    }
    const auto* const row = std::ranges::find(operations, make, &OperationRow::first);
    if (row == operations.end()) return refuse_complex(offset);
    ComplexFunctions numbers(builder_);
    const ComplexNodes left = nodes_of(a);
    const ComplexNodes right = nodes_of(b);
    return complex((numbers.*row->second)(left, right), offset);
}

GraphValues::Built GraphValues::complex_call(const Function& function, const BuiltValues& values,
                                             std::size_t offset) {
    std::vector<ComplexNodes> of;
    for (const BuiltValue& value : values) {
        if (value.is_vector() || value.is_list()) {
            return fail(offset, filled(tr("{0} takes a number, not {1}"),
                                       {function.name, value.described()}));
        }
        of.push_back(nodes_of(value));
    }
    ComplexFunctions numbers(builder_);
    const ComplexNodes first = of.front();
    const NodeId zero = builder_.constant(0.0);
    const auto real = [&](NodeId id) { return done(id, offset); };
    if (function.composed == Composed::RealPart) return real(first.re);
    if (function.composed == Composed::ImaginaryPart) return real(first.im);
    if (function.composed == Composed::Argument) return real(numbers.argument(first));
    if (function.composed == Composed::Conjugate)
        return complex({.re = first.re, .im = numbers.negative(first).im}, offset);
    const bool is_length =
        function.composed == Composed::Length || function.composed == Composed::Hypot;
    if (function.op == Op::Abs || (is_length && of.size() == 1))
        return real(numbers.modulus(first));
    std::optional<ComplexNodes> result;
    if (function.op && of.size() == 1) result = numbers.call(*function.op, first);
    if (function.composed)
        result =
            composed(numbers, *function.composed, of, {.re = builder_.constant(1.0), .im = zero});
    if (result) return complex(*result, offset);
    return fail(offset, filled(tr("{0} of a complex number is not read"), {function.name}),
                filled(tr("type abs, Re, Im or arg of it, as in {0}"), {"z = Re((x + i y)^2)"}));
}

}  // namespace zeroset
