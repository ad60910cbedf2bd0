#include "document/import/foreign_formula.hpp"
#include "document/import/real_functions.hpp"
#include "engine/base/text.hpp"

#include <cmath>

namespace zeroset {
namespace {

std::optional<double> joined(double a, std::string_view sign, double b) {
    if (sign == "+") return a + b;
    if (sign == "-") return a - b;
    if (sign == "*") return a * b;
    if (sign == "/") return a / b;
    if (sign == "%") return std::fmod(a, b);
    const auto relation = holds(a, sign, b);
    return relation ? std::optional(*relation ? 1.0 : 0.0) : std::nullopt;
}

}  // namespace

std::optional<double> value_of(const ForeignTerm& term, const ValueOfName& value_of_name) {
    if (term.kind == TermKind::Number) return number_from<double>(term.text);
    if (term.kind == TermKind::Name) return value_of_name(term.text);
    std::vector<double> values;
    for (const ForeignTerm& operand : term.operands) {
        const auto value = value_of(operand, value_of_name);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    if (term.kind == TermKind::Call) return real_function(term.text, values);
    if (term.kind == TermKind::Power) return std::pow(values[0], values[1]);
    if (term.kind == TermKind::Prefix)
        return term.text == "-" ? -values[0] : (values[0] == 0.0 ? 1.0 : 0.0);
    std::optional<double> result = values[0];
    for (std::size_t i = 1; i < values.size() && result; ++i)
        result = joined(*result, term.signs[i], values[i]);
    return result;
}

}  // namespace zeroset
