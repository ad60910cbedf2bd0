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
    OfOne{"sqrt", [](double a) { return std::sqrt(a); }},
    OfOne{"cbrt", [](double a) { return std::cbrt(a); }},
    OfOne{"exp", [](double a) { return std::exp(a); }},
    OfOne{"log", [](double a) { return std::log(a); }},
    OfOne{"ln", [](double a) { return std::log(a); }},
    OfOne{"log10", [](double a) { return std::log10(a); }},
    OfOne{"log2", [](double a) { return std::log2(a); }},
    OfOne{"sin", [](double a) { return std::sin(a); }},
    OfOne{"cos", [](double a) { return std::cos(a); }},
    OfOne{"tan", [](double a) { return std::tan(a); }},
    OfOne{"asin", [](double a) { return std::asin(a); }},
    OfOne{"acos", [](double a) { return std::acos(a); }},
    OfOne{"atan", [](double a) { return std::atan(a); }},
    OfOne{"arcsin", [](double a) { return std::asin(a); }},
    OfOne{"arccos", [](double a) { return std::acos(a); }},
    OfOne{"arctan", [](double a) { return std::atan(a); }},
    OfOne{"sinh", [](double a) { return std::sinh(a); }},
    OfOne{"cosh", [](double a) { return std::cosh(a); }},
    OfOne{"tanh", [](double a) { return std::tanh(a); }},
    OfOne{"asinh", [](double a) { return std::asinh(a); }},
    OfOne{"acosh", [](double a) { return std::acosh(a); }},
    OfOne{"atanh", [](double a) { return std::atanh(a); }},
    OfOne{"abs", [](double a) { return std::abs(a); }},
    OfOne{"floor", [](double a) { return std::floor(a); }},
    OfOne{"ceil", [](double a) { return std::ceil(a); }},
    OfOne{"sqr", [](double a) { return a * a; }},
    OfOne{"degrees", [](double a) { return a * 180.0 / std::numbers::pi; }},
    OfOne{"radians", [](double a) { return a * std::numbers::pi / 180.0; }},
};
constexpr std::array of_two{
    OfTwo{"pow", [](double a, double b) { return std::pow(a, b); }},
    OfTwo{"atan2", [](double a, double b) { return std::atan2(a, b); }},
    OfTwo{"mod", [](double a, double b) { return std::fmod(a, b); }},
    OfTwo{"div", [](double a, double b) { return std::trunc(a / b); }},
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

}  // namespace zeroset
