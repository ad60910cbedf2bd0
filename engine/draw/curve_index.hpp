#pragma once

#include "engine/draw/curve_cells.hpp"
#include "engine/draw/space_curve.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace zeroset {

/// A point of one of some curves: a share of the way from its point `point` to the next.
struct PlaceOnCurve {
    std::size_t curve, point;
    double share = 0.0;
};

/// Which points of curves are in a cell, on each of some levels.
class CurveIndex {
public:
    /// `domain` lives longer.
    CurveIndex(const CurveDomain& domain, int first_level, int last_level)
        : domain_(domain), first_level_(first_level), last_level_(last_level) {}

    /// `spacing`: how far points that are kept may be from the next.
    void add(const SpaceCurve& curve, std::size_t number,
             const std::function<double(const glm::dvec3&)>& spacing);
    /// Points in a cell and in those that touch it.
    [[nodiscard]] std::vector<PlaceOnCurve> near(const CellPlace& place) const;

private:
    void add(const PlaceOnCurve& at, const glm::dvec3& point);

    const CurveDomain& domain_;
    int first_level_, last_level_;
    std::unordered_map<std::uint64_t, std::vector<PlaceOnCurve>> points_;
};

}  // namespace zeroset
