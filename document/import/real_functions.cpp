#include "document/import/real_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace zeroset {
namespace {

struct OfOne {
    std::string_view name;
    double (*function)(double);
};
struct OfTwo {
    std::string_view name;
    double (*function)(double, double);
};

// Lambdas, as the overloads of <cmath> have no address.
constexpr std::array of_one{
    OfOne{.name = "sqrt", .function = [](double a) { return std::sqrt(a); }},
    OfOne{.name = "cbrt", .function = [](double a) { return std::cbrt(a); }},
    OfOne{.name = "exp", .function = [](double a) { return std::exp(a); }},
    OfOne{.name = "log", .function = [](double a) { return std::log(a); }},
    OfOne{.name = "ln", .function = [](double a) { return std::log(a); }},
    OfOne{.name = "log10", .function = [](double a) { return std::log10(a); }},
    OfOne{.name = "log2", .function = [](double a) { return std::log2(a); }},
    OfOne{.name = "sin", .function = [](double a) { return std::sin(a); }},
    OfOne{.name = "cos", .function = [](double a) { return std::cos(a); }},
    OfOne{.name = "tan", .function = [](double a) { return std::tan(a); }},
    OfOne{.name = "asin", .function = [](double a) { return std::asin(a); }},
    OfOne{.name = "acos", .function = [](double a) { return std::acos(a); }},
    OfOne{.name = "atan", .function = [](double a) { return std::atan(a); }},
    OfOne{.name = "arcsin", .function = [](double a) { return std::asin(a); }},
    OfOne{.name = "arccos", .function = [](double a) { return std::acos(a); }},
    OfOne{.name = "arctan", .function = [](double a) { return std::atan(a); }},
    OfOne{.name = "sinh", .function = [](double a) { return std::sinh(a); }},
    OfOne{.name = "cosh", .function = [](double a) { return std::cosh(a); }},
    OfOne{.name = "tanh", .function = [](double a) { return std::tanh(a); }},
    OfOne{.name = "asinh", .function = [](double a) { return std::asinh(a); }},
    OfOne{.name = "acosh", .function = [](double a) { return std::acosh(a); }},
    OfOne{.name = "atanh", .function = [](double a) { return std::atanh(a); }},
    OfOne{.name = "abs", .function = [](double a) { return std::abs(a); }},
    OfOne{.name = "floor", .function = [](double a) { return std::floor(a); }},
    OfOne{.name = "ceil", .function = [](double a) { return std::ceil(a); }},
    OfOne{.name = "sqr", .function = [](double a) { return a * a; }},
    OfOne{.name = "degrees", .function = [](double a) { return a * 180.0 / std::numbers::pi; }},
    OfOne{.name = "radians", .function = [](double a) { return a * std::numbers::pi / 180.0; }},
};
constexpr std::array of_two{
    OfTwo{.name = "pow", .function = [](double a, double b) { return std::pow(a, b); }},
    OfTwo{.name = "atan2", .function = [](double a, double b) { return std::atan2(a, b); }},
    OfTwo{.name = "mod", .function = [](double a, double b) { return std::fmod(a, b); }},
    OfTwo{.name = "div", .function = [](double a, double b) { return std::trunc(a / b); }},
};

}  // namespace

std::optional<double> real_function(std::string_view name, std::span<const double> arguments) {
    if (arguments.empty()) return std::nullopt;
    if (name == "min") return std::ranges::min(arguments);
    if (name == "max") return std::ranges::max(arguments);
    if (arguments.size() == 1) {
        const auto* found = std::ranges::find(of_one, name, &OfOne::name);
        if (found != of_one.end()) return found->function(arguments[0]);
    }
    if (arguments.size() == 2) {
        const auto* found = std::ranges::find(of_two, name, &OfTwo::name);
        if (found != of_two.end()) return found->function(arguments[0], arguments[1]);
    }
    if (arguments.size() == 3 && name == "if")
        return arguments[0] != 0 ? arguments[1] : arguments[2];
    return std::nullopt;
}

std::optional<bool> holds(double a, std::string_view sign, double b) {
    if (sign == "<") return a < b;
    if (sign == ">") return a > b;
    if (sign == "<=") return a <= b;
    if (sign == ">=") return a >= b;
    if (sign == "=" || sign == "==") return a == b;
    if (sign == "!=") return a != b;
    if (sign == "&" || sign == "&&") return a != 0.0 && b != 0.0;
    if (sign == "|" || sign == "||") return a != 0.0 || b != 0.0;
    return std::nullopt;
}

}  // namespace zeroset
