// A tricubic B-spline along a ray, in Bernstein's form.
//
// Along an axis a cubic's Bernstein coefficients on a stretch from a to b are the values of its
// polar form at (a, a, a), (a, a, b), (a, b, b), (b, b, b); those of the B-spline's weights are no
// less than 0 in a cell, and add up to 1. Coefficient k of degree n times C(n, k) is "scaled":
// scaled coefficients multiply as those of powers do. So f's coefficients are means of the cell's,
// whatever is rounded on the way.

#include "engine/trace/voxels/spline_ray.hpp"

namespace zeroset {
namespace {

using Cubic = std::array<double, 4>;  ///< scaled coefficients, of one weight

/// The weights of the four coefficients along an axis, between two places in the cell.
std::array<Cubic, 4> weights_between(double a, double b) {
    std::array<Cubic, 4> weights{};
    const std::array<std::array<double, 3>, 4> places{{{a, a, a}, {a, a, b}, {a, b, b}, {b, b, b}}};
    constexpr std::array<double, 4> scales{1.0 / 6, 3.0 / 6, 3.0 / 6, 1.0 / 6};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [x, y, z] = places[k];
        const double cube = x * y * z;
        const double square = x * y + y * z + z * x;
        const double line = x + y + z;
        weights[0][k] = scales[k] * (1 - x) * (1 - y) * (1 - z);
        weights[1][k] = scales[k] * (3 * cube - 2 * square + 4);
        weights[2][k] = scales[k] * (1 + line + square - 3 * cube);
        weights[3][k] = scales[k] * cube;
    }
    return weights;
}

/// The weights at a place, or their slopes.
std::array<double, 4> weights_at(double t) {
    const double s = 1 - t;
    return {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * s * s * s - 6 * s * s + 4) / 6,
            t * t * t / 6};
}
std::array<double, 4> weight_slopes_at(double t) {
    const double s = 1 - t;
    return {-s * s / 2, (3 * t * t - 4 * t) / 2, (4 * s - 3 * s * s) / 2, t * t / 2};
}

/// Adds a product of scaled coefficients.
template <std::size_t count>
void add_product(const std::array<double, count>& a, const Cubic& b,
                 std::array<double, count + 3>& sum) {
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < 4; ++k)
            sum[i + k] += a[i] * b[k];
    }
}

}  // namespace

RayNonic ray_nonic(const CellCoefficients& cell, const std::array<double, 3>& at_from,
                   const std::array<double, 3>& at_to, double from, double to) {
    const auto x = weights_between(at_from[0], at_to[0]);
    const auto y = weights_between(at_from[1], at_to[1]);
    const auto z = weights_between(at_from[2], at_to[2]);
    RayNonic f{.b = {}, .from = from, .to = to};
    const double* number = cell.data();
    for (std::size_t k = 0; k < 4; ++k) {
        std::array<double, 7> in_slice{};
        for (std::size_t j = 0; j < 4; ++j, number += 4) {
            Cubic in_row{};
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t n = 0; n < 4; ++n)
                    in_row[n] += number[i] * x[i][n];
            }
            add_product(in_row, y[j], in_slice);
        }
        add_product(in_slice, z[k], f.b);
    }
    constexpr std::array<double, 10> per_scale{1,         1.0 / 9,  1.0 / 36, 1.0 / 84, 1.0 / 126,
                                               1.0 / 126, 1.0 / 84, 1.0 / 36, 1.0 / 9,  1};
    for (std::size_t k = 0; k < 10; ++k)
        f.b[k] *= per_scale[k];
    return f;
}

std::array<double, 3> cell_slopes(const CellCoefficients& cell, const std::array<double, 3>& at) {
    std::array<std::array<double, 4>, 3> weights{};
    std::array<std::array<double, 4>, 3> slopes{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        weights[axis] = weights_at(at[axis]);
        slopes[axis] = weight_slopes_at(at[axis]);
    }
    std::array<double, 3> result{};
    const double* number = cell.data();
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t j = 0; j < 4; ++j, number += 4) {
            double value = 0;
            double slope = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                value += number[i] * weights[0][i];
                slope += number[i] * slopes[0][i];
            }
            result[0] += slope * weights[1][j] * weights[2][k];
            result[1] += value * slopes[1][j] * weights[2][k];
            result[2] += value * weights[1][j] * slopes[2][k];
        }
    }
    return result;
}

}  // namespace zeroset
