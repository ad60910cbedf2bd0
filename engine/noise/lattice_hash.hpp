#pragma once

#include <array>
#include <cmath>
#include <cstdint>

// The numbers that noise draws at lattice points: the same on every machine.

namespace zeroset {

/// Mixes the bits of a number (C. Wellons' lowbias32): one to one, and each bit of the result
/// depends on all bits of the number.
constexpr std::uint32_t mixed_bits(std::uint32_t h) {
    h = (h ^ h >> 16U) * 0x7FEB352DU;
    h = (h ^ h >> 15U) * 0x846CA68BU;
    return h ^ h >> 16U;
}

/// The number that all hashes of a seed start from.
constexpr std::uint32_t hash_of_seed(std::uint32_t seed) { return mixed_bits(seed + 0x9E3779B9U); }
/// The hash of a lattice point (i, j, k): each coordinate after the other is taken in and mixed.
constexpr std::uint32_t with_coordinate(std::uint32_t hash, std::uint32_t coordinate) {
    return mixed_bits(hash ^ coordinate);
}

/// The number from 0 to 1 that the upper 24 bits of a hash give.
constexpr double share_of_bits(std::uint32_t hash) {
    return static_cast<double>(hash >> 8U) * 0x1p-24;
}

/// A whole number modulo 2^32: lattices repeat after so many cells.
inline std::uint32_t lattice_coordinate(double whole) {
    constexpr double period = 0x1p32;
    constexpr double largest = 0x1p62;
    const double small = std::abs(whole) < largest ? whole : std::fmod(whole, period);
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(small));
}

/// Where a point is in the lattice of whole numbers: the cell that holds it, and where in the cell.
struct LatticePlace {
    std::array<std::uint32_t, 3> cell{};
    std::array<double, 3> share{};  ///< from 0 to 1, off by at most one rounding
};
inline LatticePlace lattice_place(const std::array<double, 3>& point) {
    LatticePlace place;
    for (std::size_t i = 0; i < 3; ++i) {
        const double below = std::floor(point[i]);
        place.cell[i] = lattice_coordinate(below);
        place.share[i] = point[i] - below;
    }
    return place;
}

/// The cells along an axis that a box meets, in few: the first one, and where in them its ends are.
struct LatticeSpan {
    double first = 0;
    int cells = 0;  ///< 0: too many

    static LatticeSpan of(double lo, double hi, int most) {
        LatticeSpan span{.first = std::floor(lo)};
        const double last = std::ceil(hi) - 1;
        const double cells = last < span.first ? 1 : last - span.first + 1;
        // Where numbers are so large that all are whole nothing is known of cells.
        constexpr double largest = 0x1p50;
        const bool few = lo <= hi && cells <= most && std::abs(lo) < largest;
        span.cells = few ? static_cast<int>(cells) : 0;
        return span;
    }
    /// The shares from which and up to which the box is in cell number `n`.
    [[nodiscard]] double from(double lo, int n) const { return n == 0 ? lo - first : 0; }
    [[nodiscard]] double to(double hi, int n) const {
        return n == cells - 1 ? hi - (first + n) : 1;
    }
};

}  // namespace zeroset
