#pragma once

#include "engine/noise/lattice_hash.hpp"
#include "engine/real/total_field.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

// Cellular noise [Worley96]: each cell of the lattice holds one point, anywhere in it; F1 is the
// distance from the nearest of these points, F2 that from the second nearest. Differs from the
// paper: one point a cell, and all cells are looked at that may hold one of the two, so that F1 and
// F2 are continuous.
//
// Over a box F1 is at least the least distance of a point from the box, and at most the least of
// the greatest distances: the same of F2 with the second least. Slopes are those of the distances
// from all points that may be the one. Everywhere F2 <= sqrt(3): for a place at m_i <= 1/2 from the
// nearer side of its cell along axis i, its own point is at most sqrt(sum (1 - m_i)^2) away, and
// the one behind the nearest side, at m, at most sqrt(sum (1 - m_i)^2 + 4 m) <= sqrt(3 (1 - m)^2 +
// 4 m)
// <= sqrt(3).

namespace zeroset {

class Cellular {
public:
    /// `rank`: 1 for F1, 2 for F2.
    Cellular(int rank, std::uint32_t seed) : rank_(rank), seed_(seed), start_(hash_of_seed(seed)) {}

    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] std::uint32_t seed() const { return seed_; }

    [[nodiscard]] PointAnswer at(const std::array<double, 3>& point, bool with_bends) const;
    void at(std::span<const std::array<double, 3>> points, PointAnswer* answers) const;
    void over(std::span<const FieldBox> boxes, BoxAnswer* answers) const;
    [[nodiscard]] BendAnswer bend(const FieldBox& box,
                                  const std::array<std::size_t, 2>& axes) const;
    /// Where the point of a cell is in it: three numbers from 0 to 1.
    [[nodiscard]] std::array<double, 3> point_in(const std::array<std::uint32_t, 3>& cell) const;

private:
    class Near;

    [[nodiscard]] BoxAnswer over(const FieldBox& box) const;

    int rank_;
    std::uint32_t seed_, start_;
};

using CellularField = TotalField<Cellular>;

}  // namespace zeroset
