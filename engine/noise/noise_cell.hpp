#pragma once

#include "engine/noise/lattice_hash.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// Numbers at the corners of a cell: corner c is at (c & 1, c >> 1 & 1, c >> 2 & 1).
using Corners = std::array<double, 8>;

/// The linear functions of a cell's corners.
struct NoiseCell {
    Corners number{};                   ///< at the cell's first corner
    std::array<Corners, 3> gradient{};  ///< whole numbers
};

/// The directions to the middles of a cube's edges, and four of them once more, as [Perlin02]
/// numbers them.
inline constexpr std::array<std::array<signed char, 16>, 3> noise_directions{{
    {1, -1, 1, -1, 1, -1, 1, -1, 0, 0, 0, 0, 1, 0, -1, 0},
    {1, 1, -1, -1, 0, 0, 0, 0, 1, -1, 1, -1, 1, -1, 1, -1},
    {0, 0, 0, 0, 1, 1, -1, -1, 1, 1, -1, -1, 0, 1, 0, -1},
}};

using CellHashes = std::array<std::uint32_t, 8>;

/// The hashes of the corners of the cell whose first corner is `first`.
inline CellHashes cell_hashes(std::uint32_t start, const std::array<std::uint32_t, 3>& first) {
    CellHashes hashes{};
    for (std::uint32_t i = 0; i < 2; ++i) {
        const std::uint32_t in_x = with_coordinate(start, first[0] + i);
        for (std::uint32_t j = 0; j < 2; ++j) {
            const std::uint32_t in_y = with_coordinate(in_x, first[1] + j);
            for (std::uint32_t k = 0; k < 2; ++k)
                hashes[i + 2 * j + 4 * k] = with_coordinate(in_y, first[2] + k);
        }
    }
    return hashes;
}

/// The number from -1 to 1 of value noise.
constexpr double noise_number(std::uint32_t hash) { return 2 * share_of_bits(hash) - 1; }

/// A component of the gradient.
constexpr double noise_gradient(std::uint32_t hash, std::size_t axis) {
    return static_cast<double>(noise_directions[axis][hash >> 28U]);
}

/// The linear function of corner c with this gradient, at the cell's first corner.
constexpr double number_of_gradient(std::size_t c, double x, double y, double z) {
    return ((c & 1U) != 0 ? -x : 0) - ((c & 2U) != 0 ? y : 0) - ((c & 4U) != 0 ? z : 0);
}

}  // namespace zeroset
