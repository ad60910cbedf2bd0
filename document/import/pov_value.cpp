#include "document/import/pov_value.hpp"

#include "document/import/placement.hpp"
#include "document/import/real_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>

namespace zeroset {
namespace {

struct Constant {
    std::string_view name;
    std::initializer_list<double> value;
};

double joined(double a, char sign, double b) {
    switch (sign) {
        case '+': return a + b;
        case '-': return a - b;
        case '*': return a * b;
        default: return a / b;
    }
}

glm::dvec3 vector_of(const PovValue& value) {
    const auto at = [&](std::size_t i) {
        return value.size() == 1 ? value[0] : i < value.size() ? value[i] : 0.0;
    };
    return {at(0), at(1), at(2)};
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
    static const std::array constants{Constant{"pi", {std::numbers::pi}},
                                      Constant{"tau", {2.0 * std::numbers::pi}},
                                      Constant{"true", {1}},
                                      Constant{"on", {1}},
                                      Constant{"yes", {1}},
                                      Constant{"false", {0}},
                                      Constant{"off", {0}},
                                      Constant{"no", {0}},
                                      Constant{"clock", {0}},
                                      Constant{"clock_delta", {1}},
                                      Constant{"frame_number", {1}},
                                      Constant{"version", {3.7}},
                                      Constant{"image_width", {1}},
                                      Constant{"image_height", {1}},
                                      Constant{"x", {1, 0, 0}},
                                      Constant{"y", {0, 1, 0}},
                                      Constant{"z", {0, 0, 1}},
                                      Constant{"u", {1, 0}},
                                      Constant{"v", {0, 1}},
                                      Constant{"t", {0, 0, 0, 1}},
                                      Constant{"White", {1, 1, 1}},
                                      Constant{"Black", {0, 0, 0}},
                                      Constant{"Red", {1, 0, 0}},
                                      Constant{"Green", {0, 1, 0}},
                                      Constant{"Blue", {0, 0, 1}},
                                      Constant{"Yellow", {1, 1, 0}},
                                      Constant{"Cyan", {0, 1, 1}},
                                      Constant{"Magenta", {1, 0, 1}},
                                      Constant{"Clear", {1, 1, 1, 1}},
                                      Constant{"Gray", {0.752941, 0.752941, 0.752941}},
                                      Constant{"Grey", {0.752941, 0.752941, 0.752941}},
                                      Constant{"Orange", {1, 0.5, 0}},
                                      Constant{"Gold", {0.8, 0.498039, 0.196078}},
                                      Constant{"Silver", {0.90, 0.91, 0.98}},
                                      Constant{"Brown", {0.647059, 0.164706, 0.164706}},
                                      Constant{"Pink", {0.737255, 0.560784, 0.560784}},
                                      Constant{"SkyBlue", {0.196078, 0.6, 0.8}},
                                      Constant{"Violet", {0.309804, 0.184314, 0.309804}},
                                      Constant{"Copper", {0.72, 0.45, 0.20}},
                                      Constant{"Navy", {0.137255, 0.137255, 0.556863}}};
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
