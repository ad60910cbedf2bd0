#include "document/import/pov_value.hpp"

#include "document/import/placement.hpp"
#include "document/import/real_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace zeroset {
namespace {

struct Constant {
    std::string_view name;
    PovValue value;
};

double joined(double a, char sign, double b) {
    switch (sign) {
        case '+': return a + b;
        case '-': return a - b;
        case '*': return a * b;
        default: return a / b;
    }
}

PovValue value_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

std::optional<PovValue> vector_function(std::string_view name, std::span<const PovValue> given) {
    if (given.empty()) return std::nullopt;
    const glm::dvec3 a = vector_of(given[0]);
    if (given.size() == 1 && name == "vlength") return PovValue{glm::length(a)};
    if (given.size() == 1 && name == "vnormalize")
        return value_of(glm::length(a) > 0.0 ? glm::normalize(a) : a);
    if (given.size() != 2) return std::nullopt;
    const glm::dvec3 b = vector_of(given[1]);
    if (name == "vdot") return PovValue{glm::dot(a, b)};
    if (name == "vcross") return value_of(glm::cross(a, b));
    if (name != "vrotate") return std::nullopt;
    Placement turned;
    for (int axis = 0; axis < 3; ++axis)
        turned = turned.then(Placement::turning(axis, b[axis] * std::numbers::pi / 180.0));
    return value_of(turned.of(a));
}

}  // namespace

glm::dvec3 vector_of(const PovValue& value) {
    const auto at = [&](std::size_t i) {
        return value.size() == 1 ? value[0] : i < value.size() ? value[i] : 0.0;
    };
    return {at(0), at(1), at(2)};
}

PovValue joined(const PovValue& a, char sign, const PovValue& b) {
    PovValue result(std::max(a.size(), b.size()));
    const auto part = [](const PovValue& value, std::size_t i) {
        if (value.size() == 1) return value[0];
        return i < value.size() ? value[i] : 0.0;
    };
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = joined(part(a, i), sign, part(b, i));
    return result;
}

std::optional<PovValue> pov_function(std::string_view name, std::span<const PovValue> arguments) {
    if (auto vector = vector_function(name, arguments)) return vector;
    std::vector<double> numbers;
    for (const PovValue& argument : arguments)
        numbers.push_back(argument.empty() ? 0.0 : argument[0]);
    if (name == "log") name = "log10";
    if (name == "int" && numbers.size() == 1) return PovValue{std::trunc(numbers[0])};
    if (name == "select" && numbers.size() >= 3) {
        const double zero = numbers[2];
        const double above = numbers.size() > 3 ? numbers[3] : numbers[2];
        return PovValue{numbers[0] < 0.0 ? numbers[1] : numbers[0] == 0.0 ? zero : above};
    }
    const auto value = real_function(name, numbers);
    if (!value) return std::nullopt;
    return PovValue{*value};
}

std::optional<PovValue> pov_constant(std::string_view name) {
    static const std::array constants{
        Constant{.name = "pi", .value = {std::numbers::pi}},
        Constant{.name = "tau", .value = {2.0 * std::numbers::pi}},
        Constant{.name = "true", .value = {1}}, Constant{.name = "on", .value = {1}},
        Constant{.name = "yes", .value = {1}}, Constant{.name = "false", .value = {0}},
        Constant{.name = "off", .value = {0}}, Constant{.name = "no", .value = {0}},
        Constant{.name = "clock", .value = {0}}, Constant{.name = "clock_delta", .value = {1}},
        Constant{.name = "frame_number", .value = {1}}, Constant{.name = "version", .value = {3.7}},
        // POV-Ray's own picture, where nothing else is asked for
        Constant{.name = "image_width", .value = {320}},
        Constant{.name = "image_height", .value = {240}}, Constant{.name = "x", .value = {1, 0, 0}},
        Constant{.name = "y", .value = {0, 1, 0}}, Constant{.name = "z", .value = {0, 0, 1}},
        Constant{.name = "u", .value = {1, 0}}, Constant{.name = "v", .value = {0, 1}},
        Constant{.name = "t", .value = {0, 0, 0, 1}}, Constant{.name = "White", .value = {1, 1, 1}},
        Constant{.name = "Black", .value = {0, 0, 0}}, Constant{.name = "Red", .value = {1, 0, 0}},
        Constant{.name = "Green", .value = {0, 1, 0}}, Constant{.name = "Blue", .value = {0, 0, 1}},
        Constant{.name = "Yellow", .value = {1, 1, 0}},
        Constant{.name = "Cyan", .value = {0, 1, 1}},
        Constant{.name = "Magenta", .value = {1, 0, 1}},
        Constant{.name = "Clear", .value = {1, 1, 1, 1}},
        Constant{.name = "Gray", .value = {0.752941, 0.752941, 0.752941}},
        Constant{.name = "Grey", .value = {0.752941, 0.752941, 0.752941}},
        Constant{.name = "Orange", .value = {1, 0.5, 0}},
        Constant{.name = "Gold", .value = {0.8, 0.498039, 0.196078}},
        Constant{.name = "Silver", .value = {0.90, 0.91, 0.98}},
        Constant{.name = "Brown", .value = {0.647059, 0.164706, 0.164706}},
        Constant{.name = "Pink", .value = {0.737255, 0.560784, 0.560784}},
        Constant{.name = "SkyBlue", .value = {0.196078, 0.6, 0.8}},
        Constant{.name = "Violet", .value = {0.309804, 0.184314, 0.309804}},
        Constant{.name = "Copper", .value = {0.72, 0.45, 0.20}},
        Constant{.name = "Navy", .value = {0.137255, 0.137255, 0.556863}}};
    // Gray05 to Gray95 are shades in percent.
    if (name.size() == 6 && (name.starts_with("Gray") || name.starts_with("Grey"))) {
        const double shade = (name[4] - '0') / 10.0 + (name[5] - '0') / 100.0;
        if (shade >= 0.0 && shade <= 1.0) return PovValue{shade, shade, shade};
    }
    const auto found = std::ranges::find(constants, name, &Constant::name);
    if (found == constants.end()) return std::nullopt;
    return PovValue(found->value);
}

}  // namespace zeroset
