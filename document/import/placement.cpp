#include "document/import/placement.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace zeroset {
namespace {

/// Rounding of the matrices that programs write with few digits.
constexpr double unequal = 1e-4;

/// The value, or 0 where it is only rounding beside `size`.
double cleaned(double value, double size) { return std::abs(value) < 1e-15 * size ? 0.0 : value; }

std::string coordinate_of(const glm::dmat3& linear, double shift, int row) {
    constexpr std::array names{"x", "y", "z"};
    double size = std::abs(shift);
    for (int i = 0; i < 3; ++i)
        size = std::max(size, std::abs(linear[i][row]));
    std::string text;
    const auto add = [&text](double factor, const std::string& name) {
        if (factor == 0.0) return;
        const bool negative = factor < 0.0;
        text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
        const double magnitude = std::abs(factor);
        if (name.empty()) {
            text += exact_number(magnitude);
        } else {
            text += magnitude == 1.0 ? name : exact_number(magnitude) + "*" + name;
        }
    };
    for (int i = 0; i < 3; ++i)
        add(cleaned(linear[i][row], size), names[static_cast<std::size_t>(i)]);
    add(cleaned(shift, size), "");
    return text.empty() ? "0" : text;
}

}  // namespace

Placement Placement::then(const Placement& next) const {
    return {.linear = next.linear * linear, .shift = next.of(shift)};
}

std::optional<Placement> Placement::inverse() const {
    const double det = glm::determinant(linear);
    if (!std::isnormal(det) || !is_finite()) return std::nullopt;
    const Placement result{.linear = glm::inverse(linear),
                           .shift = -(glm::inverse(linear) * shift)};
    if (!result.is_finite()) return std::nullopt;
    return result;
}

std::optional<double> Placement::scale() const {
    const double det = glm::determinant(linear);
    if (!(det > 0.0) || !is_finite()) return std::nullopt;
    const double factor = std::cbrt(det);
    const glm::dmat3 square = glm::transpose(linear) * linear;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const double expected = i == j ? factor * factor : 0.0;
            if (std::abs(square[i][j] - expected) > unequal * factor * factor) return std::nullopt;
        }
    }
    return factor;
}

bool Placement::is_identity() const {
    return linear == glm::dmat3(1.0) && shift == glm::dvec3(0.0);
}

bool Placement::is_finite() const {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            if (!std::isfinite(linear[i][j])) return false;
        if (!std::isfinite(shift[i])) return false;
    }
    return true;
}

Placement Placement::scaling(const glm::dvec3& factors) {
    Placement result;
    for (int i = 0; i < 3; ++i)
        result.linear[i][i] = factors[i];
    return result;
}

Placement Placement::moving(const glm::dvec3& by) { return {.shift = by}; }

Placement Placement::turning(int axis, double angle_rad) {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    Placement result;
    result.linear[a][a] = result.linear[b][b] = std::cos(angle_rad);
    result.linear[a][b] = std::sin(angle_rad);
    result.linear[b][a] = -std::sin(angle_rad);
    return result;
}

std::string coordinates_of(const Placement& placement) {
    std::string text;
    for (int row = 0; row < 3; ++row) {
        if (row > 0) text += ", ";
        text += coordinate_of(placement.linear, placement.shift[row], row);
    }
    return text;
}

Camera camera_of_view(const Placement& from_view, double half_height,
                      std::optional<double> distance) {
    const double half_angle = std::numbers::pi * default_fov_deg / 360.0;
    const double from = distance ? *distance : half_height / std::tan(half_angle);
    return {.eye = from_view.of({0.0, 0.0, from}),
            .look_at = from_view.of({0.0, 0.0, 0.0}),
            .up = glm::normalize(from_view.linear * glm::dvec3(0.0, 1.0, 0.0)),
            .fov_rad = 2.0 * std::atan(half_height / from),
            .projection = distance ? Projection::Perspective : Projection::Orthographic};
}

}  // namespace zeroset
