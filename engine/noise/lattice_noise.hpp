#pragma once

#include "engine/noise/lattice_hash.hpp"
#include "engine/real/total_field.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

// Gradient and value noise [Perlin02]: each lattice point c has a linear function
//   L_c(p) = v_c + g_c (p - c)
// and noise is their mean with the weights of the cell's eight corners, products of s or 1 - s with
//   s(t) = 6 t^5 - 15 t^4 + 10 t^3.
// Gradient noise has v_c = 0 and one of the twelve directions to the middles of a cube's edges as
// g_c, four of them twice as likely; value noise has g_c = 0 and a number from -1 to 1 as v_c. Both
// have continuous second derivatives. Differs from the paper: the hash of lattice points
// (lattice_hash.hpp) takes a seed and repeats after 2^32 cells.
//
// A box in one cell: the linear functions have exact ranges in it, s is monotone, and a mean is
// linear in each s: the range of the mean is that at the ends of the three s. Boxes in several
// cells: the hull. Larger ones: the bounds of the kind.

namespace zeroset {

enum class NoiseKind : std::uint8_t { Gradient, Value };

/// Bounds of the sizes of noise and its derivatives anywhere. noise_test proves those of gradient
/// noise by subdivision of a cell; its values that were ever found are below 1.0364.
struct NoiseBounds {
    double value, slope;
    double own_bend;    ///< twice by the same axis
    double mixed_bend;  ///< by two axes
};
constexpr NoiseBounds noise_bounds(NoiseKind kind) {
    // Value noise: s' <= 15/8, |s''| <= 10/sqrt(3), differences of numbers from -1 to 1.
    return kind == NoiseKind::Gradient
               ? NoiseBounds{.value = 1.1, .slope = 4, .own_bend = 14, .mixed_bend = 12}
               : NoiseBounds{.value = 1, .slope = 3.75, .own_bend = 11.55, .mixed_bend = 14.0625};
}

/// Bounds of the rounding errors of values, slopes and second derivatives, amply counted.
inline constexpr double noise_error = 0x1p-42;
inline constexpr double noise_slope_error = 0x1p-40;
inline constexpr double noise_bend_error = 0x1p-38;

class LatticeNoise {
public:
    LatticeNoise(NoiseKind kind, std::uint32_t seed)
        : kind_(kind), seed_(seed), start_(hash_of_seed(seed)) {}

    [[nodiscard]] NoiseKind kind() const { return kind_; }
    [[nodiscard]] std::uint32_t seed() const { return seed_; }

    [[nodiscard]] PointAnswer at(const std::array<double, 3>& point, bool with_bends) const;
    void at(std::span<const std::array<double, 3>> points, PointAnswer* answers) const;
    void over(std::span<const FieldBox> boxes, BoxAnswer* answers) const;
    [[nodiscard]] BendAnswer bend(const FieldBox& box,
                                  const std::array<std::size_t, 2>& axes) const;

private:
    class Parts;

    [[nodiscard]] bool has_gradients() const { return kind_ == NoiseKind::Gradient; }

    NoiseKind kind_;
    std::uint32_t seed_, start_;
};

using LatticeNoiseField = TotalField<LatticeNoise>;

}  // namespace zeroset
