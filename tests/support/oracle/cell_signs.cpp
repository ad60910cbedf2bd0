#include "tests/support/oracle/cell_signs.hpp"

#include "tests/support/sample_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace zeroset::test {
namespace {

using Wide = long double;

constexpr std::size_t most_coefficients = 10;  ///< of degree 9

/// A polynomial in the part s of a stretch, and one of no smaller coefficients: the sums of the
/// absolute values of all that it was made of.
struct BoundedPolynomial {
    std::array<Wide, most_coefficients> of{}, size{};
    std::size_t count = 1;

    static BoundedPolynomial line(Wide at, Wide by) {
        BoundedPolynomial line;
        line.count = 2;
        line.of = {at, by};
        line.size = {std::abs(at), std::abs(by)};
        return line;
    }
    static BoundedPolynomial number(Wide value) {
        BoundedPolynomial number;
        number.of[0] = value;
        number.size[0] = std::abs(value);
        return number;
    }
    void add(const BoundedPolynomial& other, Wide factor) {
        count = std::max(count, other.count);
        for (std::size_t i = 0; i < other.count; ++i) {
            of[i] += factor * other.of[i];
            size[i] += std::abs(factor) * other.size[i];
        }
    }
    [[nodiscard]] BoundedPolynomial times(const BoundedPolynomial& other) const {
        BoundedPolynomial product;
        product.count = count + other.count - 1;
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < other.count; ++k) {
                product.of[i + k] += of[i] * other.of[k];
                product.size[i + k] += size[i] * other.size[k];
            }
        }
        return product;
    }
};

/// The weights of the numbers about a cell along an axis, where `above` is the place in it.
std::vector<BoundedPolynomial> weights(bool is_spline, const BoundedPolynomial& above) {
    BoundedPolynomial below = BoundedPolynomial::number(1);
    below.add(above, -1);
    if (!is_spline) return {below, above};
    const auto cube = [](const BoundedPolynomial& t) {
        BoundedPolynomial sixth;
        sixth.add(t.times(t).times(t), Wide{1} / 6);
        return sixth;
    };
    const auto middle = [](const BoundedPolynomial& t) {  // (3 t^3 - 6 t^2 + 4) / 6
        const BoundedPolynomial square = t.times(t);
        BoundedPolynomial sum = BoundedPolynomial::number(Wide{4} / 6);
        sum.add(square.times(t), Wide{1} / 2);
        sum.add(square, -1);
        return sum;
    };
    return {cube(below), middle(above), middle(below), cube(above)};
}

/// The cell's place along an axis as a line in s, and a bound of what is rounded in it.
struct PlaceLine {
    BoundedPolynomial place;
    Wide error;
};
PlaceLine place_line(const CellLevel& of, std::size_t axis, const RayQuestion& ray, double from,
                     double to) {
    if (of.fixed[axis]) return {.place = BoundedPolynomial::number(*of.fixed[axis]), .error = 0};
    const IndexMap& map = of.volume.data().map();
    Wide at = map.shift[axis];
    Wide by = 0;
    Wide terms = std::abs(at);
    for (std::size_t c = 0; c < 3; ++c) {
        const Wide row = map.index_from_world[axis][c];
        at += row * (ray.eye[c] + Wide{ray.direction[c]} * from);
        by += row * ray.direction[c];
        terms += std::abs(row) *
                 (std::abs(Wide{ray.eye[c]}) +
                  std::abs(Wide{ray.direction[c]}) * std::max(std::abs(from), std::abs(to)));
    }
    const auto cell = static_cast<Wide>(of.cell[axis]);
    return {.place = BoundedPolynomial::line(at - cell, by * (Wide{to} - from)),
            .error = 0x1p-58L * (terms + cell + 1)};
}

/// The numbers about a cell, the first axis fastest.
std::vector<double> numbers_about(const CellLevel& of) {
    const SplineData* const spline = of.volume.spline();
    const std::size_t count = spline != nullptr ? 4 : 2;
    std::vector<double> numbers;
    for (std::size_t n = 0; n < count * count * count; ++n) {
        const std::array at{of.cell[0] + n % count, of.cell[1] + n / count % count,
                            of.cell[2] + n / (count * count)};
        numbers.push_back(spline != nullptr ? coefficient_at(*spline, at[0], at[1], at[2])
                                            : sample_at(of.volume.data(), at[0], at[1], at[2]));
    }
    return numbers;
}

/// The volume in the cell less the level, along the stretch.
BoundedPolynomial along_stretch(const CellLevel& of, const std::vector<double>& numbers,
                                const std::array<std::vector<BoundedPolynomial>, 3>& weights) {
    const std::size_t count = weights[0].size();
    BoundedPolynomial f = BoundedPolynomial::number(-(Wide{of.lo} + of.hi) / 2);
    auto number = numbers.begin();
    for (std::size_t k = 0; k < count; ++k) {
        BoundedPolynomial in_slice;
        for (std::size_t j = 0; j < count; ++j) {
            BoundedPolynomial in_row;
            for (std::size_t i = 0; i < count; ++i)
                in_row.add(weights[0][i], *number++);
            in_slice.add(in_row.times(weights[1][j]), 1);
        }
        f.add(in_slice.times(weights[2][k]), 1);
    }
    return f;
}

/// The sign that numbers between these have, if they are known to +-bound.
StretchSign sign_between(Wide least, Wide most, Wide bound) {
    if (least > bound) return StretchSign::Above;
    return most < -bound ? StretchSign::Below : StretchSign::Unknown;
}

}  // namespace

StretchSign sign_in_cell(const CellLevel& of, const RayQuestion& ray, double from, double to) {
    const std::vector<double> numbers = numbers_about(of);
    const auto [low, high] = std::ranges::minmax(numbers);
    const Wide largest = std::max(std::abs(low), std::abs(high));
    // f lies between them, but for a stretch that ends a little beyond the cell.
    const StretchSign by_numbers = sign_between(low - Wide{of.hi}, high - Wide{of.lo},
                                                1e-6L * (largest + std::abs(Wide{of.lo})));
    if (by_numbers != StretchSign::Unknown) return by_numbers;
    std::array<std::vector<BoundedPolynomial>, 3> along;
    Wide error = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const PlaceLine line = place_line(of, axis, ray, from, to);
        along[axis] = weights(of.volume.spline() != nullptr, line.place);
        error = std::max(error, line.error);
    }
    const BoundedPolynomial f = along_stretch(of, numbers, along);
    Wide least = std::numeric_limits<Wide>::infinity();
    Wide most = -least;
    Wide size = 0;
    for (std::size_t k = 0; k < f.count; ++k) {
        Wide coefficient = 0;  // of Bernstein's polynomial k
        Wide share = 1;        // C(k, i) / C(n, i)
        for (std::size_t i = 0; i <= k; ++i) {
            coefficient += share * f.of[i];
            share *= static_cast<Wide>(k - i) /
                     static_cast<Wide>(std::max<std::size_t>(f.count - 1 - i, 1));
        }
        least = std::min(least, coefficient);
        most = std::max(most, coefficient);
        size += f.size[k];
    }
    // Some 100 roundings of 2^-64; slopes along the cell's axes are at most twice the largest
    // number about it.
    return sign_between(least, most, 0x1p-54L * size + 8 * largest * error + (Wide{of.hi} - of.lo));
}

}  // namespace zeroset::test
