#pragma once

#include "engine/draw/curve_system.hpp"
#include "engine/draw/page.hpp"
#include "engine/draw/space_curve.hpp"
#include "engine/scene/region.hpp"
#include "engine/trace/time_limit.hpp"

#include <glm/ext/vector_int3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// Where a curve is looked for: a box, which may be without extent along an axis, as far as the
/// region and the page go.
struct CurveDomain {
    Box box;
    Region region = {};
    const Page& page;

    [[nodiscard]] bool is_flat(int axis) const { return !(box.lo[axis] < box.hi[axis]); }
    /// Whether the point is in the box, up to rounding, and on the page.
    [[nodiscard]] bool contains(const glm::dvec3& point) const;
    /// False where no point of the box is in the region or on the page.
    [[nodiscard]] bool may_contain(const Box& cell) const;
};

/// A cell of the octree over a domain's box: `at` counts cells of its level.
struct CellPlace {
    int level = 0;
    glm::ivec3 at{0};

    bool operator==(const CellPlace&) const = default;
};
/// Different for different places of at most 20 levels.
std::uint64_t key_of(const CellPlace& place);
CellPlace place_of(const CurveDomain& domain, int level, const glm::dvec3& point);
Box box_of(const CurveDomain& domain, const CellPlace& place);
/// The box and half as much again on each side.
Box around(const Box& box);
/// The eight parts, or four or two of a flat domain.
std::vector<CellPlace> parts_of(const CurveDomain& domain, const CellPlace& place);

struct CurveCell {
    CellPlace place;
    Box box;
    glm::dvec3 tangent{0.0};  ///< of a regular cell
};

struct SearchLimits {
    double smallest_pt = 0.05;        ///< cells that are smaller on the page are not divided
    std::size_t most_cells = 60'000;  ///< cells on one level
    TimeLimit time = {};
    /// Curves on which the equations are known to vanish without telling a direction: cells on them
    /// are divided to `singular_pt` only.
    std::vector<const SpaceCurve*> singular = {};
    double singular_pt = 0.4;

    /// These limits with half of the time that is left.
    [[nodiscard]] SearchLimits with_half_time() const;
};

/// The cells that may hold points of a curve; beside them there are none, in proof.
struct CurveCells {
    std::vector<CurveCell> regular;  ///< of different levels
    std::vector<CurveCell> open;     ///< not regular, not divided further
    std::size_t singular = 0;        ///< number of those on SearchLimits::singular
    std::size_t seen = 0;            ///< cells looked at
    bool in_time = true;             ///< the time sufficed to divide them
};

/// The given cells that may hold a point of the curve, by enclosures of the functions, in the
/// domain.
std::vector<CurveCell> sifted(const CurveSystem& system, const CurveDomain& domain,
                              const TimeLimit& time, std::vector<CurveCell> cells);
/// Judges cells of one level; those that the time does not suffice for are open.
std::vector<JudgedCell> judge_cells(const CurveSystem& system, const std::vector<CurveCell>& cells,
                                    const TimeLimit& time = {});

CurveCells find_cells(const CurveSystem& system, const CurveDomain& domain,
                      const SearchLimits& limits);

}  // namespace zeroset
