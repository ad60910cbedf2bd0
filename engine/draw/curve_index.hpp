#pragma once

#include "engine/draw/curve_cells.hpp"
#include "engine/draw/space_curve.hpp"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace zeroset {

/// A point of one of some curves.
struct PlaceOnCurve {
    std::size_t curve, point;
};

/// Which points of curves are in a cell, on each of some levels.
class CurveIndex {
public:
    /// `domain` lives longer.
    CurveIndex(const CurveDomain& domain, int first_level, int last_level)
        : domain_(domain), first_level_(first_level), last_level_(last_level) {}

    void add(const SpaceCurve& curve, std::size_t number);
    /// Points in a cell and those that touch it, one for each stay of a curve in a cell.
    [[nodiscard]] std::vector<PlaceOnCurve> near(const CellPlace& place) const;

private:
    const CurveDomain& domain_;
    int first_level_, last_level_;
    std::unordered_map<std::uint64_t, std::vector<PlaceOnCurve>> points_;
};

}  // namespace zeroset
