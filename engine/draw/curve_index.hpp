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
        : domain_(domain),
          first_level_(first_level),
          levels_(static_cast<std::size_t>(last_level - first_level) + 1) {}

    /// `spacing`: how far points that are kept may be from the next.
    void add(const SpaceCurve& curve, std::size_t number,
             const std::function<double(const glm::dvec3&)>& spacing);
    /// Points in a cell and in those that touch it: of each stretch of a curve there, and of each
    /// way from one of its points to the next.
    void near(const CellPlace& place, std::vector<PlaceOnCurve>& found) const;
    [[nodiscard]] bool has_near(const CellPlace& place) const;

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    struct Entry {
        PlaceOnCurve at;
        std::uint32_t next;  ///< of the same cell
    };
    /// Entries of a cell.
    struct Chain {
        std::uint32_t first, last;
    };
    struct Level {
        std::unordered_map<std::uint64_t, Chain> cells;
        std::uint64_t last_key = 0;  ///< where the last entry is
        PlaceOnCurve last{.curve = none, .point = 0};
    };

    void add(const PlaceOnCurve& at, const glm::dvec3& point);
    void add(const PlaceOnCurve& at, std::uint64_t key, Level& level);
    /// Calls `visit` for each entry near a cell until that is true.
    template <class Visit>
    bool visit_near(const CellPlace& place, Visit visit) const;

    const CurveDomain& domain_;
    int first_level_;
    std::vector<Level> levels_;
    std::vector<Entry> entries_;
};

}  // namespace zeroset
