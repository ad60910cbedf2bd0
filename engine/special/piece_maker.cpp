#include "engine/special/piece_maker.hpp"

#include "engine/special/mpfr_value.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t point_count = piece_degree + 1;
constexpr mpfr_prec_t working_bits = 128;
/// The relative error of one operation in double, in any rounding mode.
constexpr double rounding_unit = unit_of<double>;

/// The matrix that takes numbers at the Chebyshev points of [-1, 1] to coefficients of powers.
class Interpolation {
public:
    Interpolation() {
        for (std::size_t i = 0; i < point_count; ++i) {
            points_.emplace_back(working_bits);
            set_cosine(points_.back(), 2 * i + 1);
        }
        // Coefficients of T_k by the recurrence, whole numbers.
        std::array<std::array<double, point_count>, point_count> powers{};
        powers[0][0] = powers[1][1] = 1;
        for (std::size_t k = 2; k < point_count; ++k) {
            for (std::size_t n = 0; n < point_count; ++n)
                powers[k][n] = (n > 0 ? 2 * powers[k - 1][n - 1] : 0) - powers[k - 2][n];
        }
        MpfrValue cosine(working_bits);
        for (std::size_t n = 0; n < point_count; ++n) {
            for (std::size_t i = 0; i < point_count; ++i) {
                MpfrValue& sum = weights_.emplace_back(working_bits, 0.0);
                for (std::size_t k = n; k < point_count; ++k) {
                    set_cosine(cosine, k * (2 * i + 1));
                    mpfr_mul_d(cosine, cosine, powers[k][n] * (k == 0 ? 1 : 2), MPFR_RNDN);
                    mpfr_add(sum, sum, cosine, MPFR_RNDN);
                }
                mpfr_div_ui(sum, sum, point_count, MPFR_RNDN);
            }
        }
    }

    [[nodiscard]] mpfr_srcptr point(std::size_t i) const { return points_[i]; }
    [[nodiscard]] mpfr_srcptr weight(std::size_t n, std::size_t i) const {
        return weights_[n * point_count + i];
    }

private:
    /// cos(n pi/32)
    static void set_cosine(MpfrValue& to, std::size_t n) {
        mpfr_const_pi(to, MPFR_RNDN);
        mpfr_mul_ui(to, to, n % (4 * point_count), MPFR_RNDN);
        mpfr_div_ui(to, to, 2 * point_count, MPFR_RNDN);
        mpfr_cos(to, to, MPFR_RNDN);
    }

    std::deque<MpfrValue> points_, weights_;
};

const Interpolation& interpolation() {
    static const Interpolation weights;
    return weights;
}

/// n (n - 1) ... (n - order + 1)
double falling_factorial(int n, int order) {
    double product = 1;
    for (int i = 0; i < order; ++i)
        product *= n - i;
    return product;
}

/// ln of M rho^-16 for the ellipse that gives the least.
double log_left_out(const Analytic& f, double middle, double half) {
    double least = unbounded;
    for (const double rho : {4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0, 64.0, 96.0}) {
        const double along = 0.5 * half * (rho + 1 / rho);
        const double across = 0.5 * half * (rho - 1 / rho);
        if (!f.from_zero && along >= middle) break;
        const double bound =
            f.log_bound({.from = middle - along, .to = middle + along, .height = across});
        least = std::min(least, bound - static_cast<double>(point_count) * std::log(rho));
    }
    return least + 0.01;  // logarithms are rounded
}

void set_errors(Piece& piece, double log_rest) {
    constexpr double tiny = 0x1p-1000;  // beyond what roundings of denormals are
    double odd_product = 1;
    for (std::size_t s = 0; s < known_orders; ++s) {
        const int order = static_cast<int>(s);
        if (s > 0) odd_product *= static_cast<double>(2 * s - 1);
        const double steepest = std::pow(double{point_count}, 2 * order) / odd_product;
        double sizes = 0;
        double roundings = 0;
        for (std::size_t n = 0; n < point_count; ++n) {
            const double term = falling_factorial(static_cast<int>(n), order);
            sizes += std::abs(piece.coefficients[n]);
            roundings += static_cast<double>(3 * n + 6) * term * std::abs(piece.coefficients[n]);
        }
        // The terms of the rest fall by 0.41 and more: 4 M rho^-k k^(2s) adds up to 6.8 M rho^-16.
        const double rest = 8 * std::exp(log_rest) * steepest;
        const double inexact = 0x1p-80 * steepest * sizes;  // 128 bits, of which weights take some
        piece.errors[s] = (rest + inexact + rounding_unit * roundings + tiny) * 1.01 *
                          std::pow(piece.per_half, order);
    }
}

}  // namespace

Piece make_piece(const Analytic& f, double from, double width) {
    const Interpolation& with = interpolation();
    const double half = 0.5 * width;
    Piece piece{.middle = from + half, .per_half = 1 / half};
    std::deque<MpfrValue> values;
    MpfrValue x(working_bits);
    for (std::size_t i = 0; i < point_count; ++i) {
        mpfr_mul_d(x, with.point(i), half, MPFR_RNDN);
        mpfr_add_d(x, x, piece.middle, MPFR_RNDN);
        f.value(values.emplace_back(working_bits), x);
    }
    MpfrValue sum(working_bits);
    for (std::size_t n = 0; n < point_count; ++n) {
        mpfr_set_zero(sum, 1);
        for (std::size_t i = 0; i < point_count; ++i)
            mpfr_fma(sum, with.weight(n, i), values[i], sum, MPFR_RNDN);
        piece.coefficients[n] = mpfr_get_d(sum, MPFR_RNDN);
    }
    set_errors(piece, log_left_out(f, piece.middle, half));
    return piece;
}

namespace {

/// Looks for parts of a piece in which a derivative may turn.
class TurnSearch {
public:
    TurnSearch(const Piece& piece, int order, std::vector<PieceTurn>& turns)
        : piece_(piece), order_(order), turns_(turns) {
        const auto s = static_cast<std::size_t>(order);
        error_ = piece.errors[s];
        slope_error_ = piece.errors[s + 1] / piece.per_half;
        // Powers about another place than the middle are at most 2^n times as large.
        for (int n = 0; n <= piece_degree; ++n)
            slope_error_ += 64 * rounding_unit * falling_factorial(n, order + 1) *
                            std::ldexp(std::abs(coefficient(n)), n) *
                            std::pow(piece.per_half, order);
    }

    /// `middle` and `half` are of t.
    void search(double middle, double half) {
        const std::array<double, point_count> powers = powers_about(middle, half);
        // How much the derivative changes: by its slope in the middle, and by what is left.
        const double scale = std::pow(piece_.per_half / half, order_);
        const auto change = [&](int n) {
            return scale * falling_factorial(n, order_ + 1) *
                   std::abs(powers[static_cast<std::size_t>(n)]);
        };
        const double by_slope = change(order_ + 1);
        double rest = slope_error_ * half;
        for (int n = order_ + 2; n <= piece_degree; ++n)
            rest += change(n);
        if (by_slope > 1.01 * rest) return;
        // The error is at least 2^-50 of what the polynomial is made of, so that this ends.
        if (const double moves = by_slope + 1.01 * rest; moves <= 4 * error_) {
            add(middle, half, moves + 2 * error_);
        } else {
            search(middle - 0.5 * half, 0.5 * half);
            search(middle + 0.5 * half, 0.5 * half);
        }
    }

private:
    [[nodiscard]] double coefficient(int n) const {
        return piece_.coefficients[static_cast<std::size_t>(n)];
    }
    /// The coefficients by powers of (t - middle)/half.
    [[nodiscard]] std::array<double, point_count> powers_about(double middle, double half) const {
        std::array<double, point_count> powers = piece_.coefficients;
        double scale = 1;
        for (std::size_t first = 0; first < point_count; ++first) {
            for (std::size_t n = point_count - 1; n-- > first;)
                powers[n] += middle * powers[n + 1];
            powers[first] *= scale;
            scale *= half;
        }
        return powers;
    }
    void add(double middle, double half, double by) {
        const double half_length = 1 / piece_.per_half;
        const double value = piece_.at(piece_.middle + middle * half_length, order_);
        const PieceTurn turn{.from = piece_.middle + (middle - half) * half_length,
                             .to = piece_.middle + (middle + half) * half_length,
                             .bounds = {.lo = value - by, .hi = value + by}};
        if (!turns_.empty() && turns_.back().to == turn.from) {
            turns_.back().to = turn.to;
            turns_.back().bounds.add(turn.bounds);
        } else {
            turns_.push_back(turn);
        }
    }

    const Piece& piece_;
    int order_;
    std::vector<PieceTurn>& turns_;
    double error_ = 0, slope_error_ = 0;
};

}  // namespace

void add_turns(const Piece& piece, int order, std::vector<PieceTurn>& turns) {
    TurnSearch(piece, order, turns).search(0, 1);
}

}  // namespace zeroset
