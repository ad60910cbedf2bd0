#pragma once

#include "engine/special/analytic.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

// A function of x >= 0 as polynomials of degree 15 over short pieces of the line, made with MPFR
// when they are first asked for. Each equals f at the 16 roots of T_16 in its piece. With M a bound
// of |f| in the ellipse about the piece whose half axes are (rho + 1/rho)/2 and (rho - 1/rho)/2 of
// the piece's half length, the Chebyshev coefficients of f are |a_k| <= 2 M rho^-k [Trefethen13,
// th. 8.1]. At those roots T_k is T_m, -T_m or 0 for some m < 16: what is left out of f is
//   the sum over k > 15 of a_k (T_k - T_m, T_k + T_m or T_k),
// and |T_k^(s)| <= k^2 (k^2 - 1) ... (k^2 - (s - 1)^2)/(1 3 ... (2 s - 1)) on [-1, 1].

namespace zeroset {

/// How many derivatives are known, f itself among them.
inline constexpr std::size_t known_orders = 5;
/// Up to this order ranges are known, too.
inline constexpr int highest_ranged_order = 3;
inline constexpr int piece_degree = 15;
/// The error of values beyond the last piece, known only where their bounds are as near.
inline constexpr double error_beyond = 0x1p-50;

/// Approximates f about `middle`, by powers of t = (x - middle) per_half from -1 to 1.
struct Piece {
    double middle = 0, per_half = 0;
    std::array<double, piece_degree + 1> coefficients{};
    /// Bounds of |derivative - computed one| in the piece, in any rounding mode.
    std::array<double, known_orders> errors{};

    /// A derivative by x of the polynomial.
    [[nodiscard]] double at(double x, int order) const;
};

/// A point with its piece, or without one where f is not known, and what is computed there.
struct PieceSample {
    const Piece* piece = nullptr;
    double t = 0;
    double value = 0, slope = 0;  ///< the derivative of the order that is asked for, and the next
};
/// Computes values and slopes of samples, which have pieces, to the last bit alike among others.
void evaluate(std::span<PieceSample> samples, int order);

class Pieces {
public:
    explicit Pieces(Analytic f);
    Pieces(const Pieces&) = delete;
    Pieces& operator=(const Pieces&) = delete;
    ~Pieces();

    [[nodiscard]] const Analytic& function() const { return f_; }
    /// The piece at x >= 0; nullptr where there is none.
    [[nodiscard]] const Piece* piece(double x) const;
    /// Adds to `bounds` all extremes of a derivative in [lo, hi] that may lie inside, and what lies
    /// beyond the pieces; 0 <= lo <= hi.
    void add_inner(double lo, double hi, int order, ValueBounds& bounds) const;
    /// A bound of the errors of a derivative in [lo, hi]; unbounded where pieces are not made yet.
    [[nodiscard]] double error_over(double lo, double hi, int order) const;

private:
    struct Block;

    [[nodiscard]] std::size_t block_at(double x) const;
    [[nodiscard]] const Block& block(std::size_t index) const;

    Analytic f_;
    double start_;      ///< where pieces begin
    std::size_t last_;  ///< the index of the last block
    mutable std::mutex mutex_;
    mutable std::vector<std::atomic<const Block*>> blocks_;
};

}  // namespace zeroset
