#include "engine/draw/curve_finder.hpp"

#include "engine/draw/curve_index.hpp"
#include "engine/draw/curve_tracer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

// In a regular cell each plane across its tangent holds at most one point of the curve: so where a
// curve that was followed passes all of the cell's planes within the box around it, there is no
// other. A cell that is not passed so is a start for another curve, or is divided until it is, or
// is empty.

namespace zeroset {
namespace {

/// Steps are at most this part of a cell's least side.
constexpr double step_part = 0.4;
/// How often a regular cell is divided that no curve passes.
constexpr int most_divisions = 6;
/// Open cells from which curves are tried to be found.
constexpr std::size_t most_tries = 4'000;

/// A regular cell's frame: planes across `tangent`, numbered by their distance from `centre`.
struct Passage {
    Box around;
    glm::dvec3 centre, tangent;

    [[nodiscard]] double offset(const glm::dvec3& point) const {
        return glm::dot(point - centre, tangent);
    }
    [[nodiscard]] bool holds(const glm::dvec3& point) const {
        const double slack = 1e-9 * around.size();
        return glm::all(glm::greaterThanEqual(point, around.lo - slack)) &&
               glm::all(glm::lessThanEqual(point, around.hi + slack));
    }
};

/// The planes between two offsets.
struct Offsets {
    double lo, hi;
    [[nodiscard]] bool cover(const Offsets& other) const {
        return lo <= other.lo && hi >= other.hi;
    }
};

Offsets offsets_of(const Passage& passage, const Box& box) {
    const double middle = passage.offset(box.centre());
    const double half = 0.5 * glm::dot(glm::abs(passage.tangent), box.hi - box.lo);
    return {.lo = middle - half, .hi = middle + half};
}

class CurveFinder {
public:
    CurveFinder(const CurveSystem& system, const CurveDomain& domain, const SearchLimits& limits)
        : system_(system),
          domain_(domain),
          limits_(limits),
          cells_(find_cells(system, domain, limits)),
          index_(domain, first_level(), last_level()) {
        for (std::size_t i = 0; i < cells_.regular.size(); ++i)
            regular_.emplace(key_of(cells_.regular[i].place), i);
    }

    FoundCurves run();

private:
    [[nodiscard]] int first_level() const;
    [[nodiscard]] int last_level() const;
    [[nodiscard]] double longest_step(const glm::dvec3& place) const;
    void settle(const CurveCell& cell, const Passage& passage, int divisions);
    void divide(const CurveCell& cell, const Passage& passage, int divisions);
    void leave_open(const Box& box);
    void try_open_cell(const CurveCell& cell);
    bool follow(const glm::dvec3& start);
    /// The planes that a followed curve passes within the passage's box about one of its points.
    [[nodiscard]] Offsets passed(const Passage& passage, const PlaceOnCurve& at,
                                 const Offsets& wanted) const;
    [[nodiscard]] double passed_one_way(const Passage& passage, const PlaceOnCurve& at, double sign,
                                        double wanted) const;
    [[nodiscard]] bool is_passed(const CurveCell& cell, const Passage& passage,
                                 const Offsets& wanted) const;

    const CurveSystem& system_;
    const CurveDomain& domain_;
    const SearchLimits& limits_;
    CurveCells cells_;
    std::unordered_map<std::uint64_t, std::size_t> regular_;
    CurveIndex index_;
    FoundCurves found_;
};

int CurveFinder::first_level() const {
    int level = 20;
    for (const CurveCell& cell : cells_.regular)
        level = std::min(level, cell.place.level);
    return cells_.regular.empty() ? 0 : level;
}

int CurveFinder::last_level() const {
    int level = 0;
    for (const CurveCell& cell : cells_.regular)
        level = std::max(level, cell.place.level);
    for (const CurveCell& cell : cells_.open)
        level = std::max(level, cell.place.level);
    return level;
}

double CurveFinder::longest_step(const glm::dvec3& place) const {
    for (int level = first_level(); level <= last_level(); ++level) {
        const auto cell = regular_.find(key_of(place_of(domain_, level, place)));
        if (cell == regular_.end()) continue;
        const Box& box = cells_.regular[cell->second].box;
        double least = box.size();
        for (int axis = 0; axis < 3; ++axis) {
            if (!domain_.is_flat(axis)) least = std::min(least, box.hi[axis] - box.lo[axis]);
        }
        return step_part * least;
    }
    return 1.0 / domain_.page.scale(place);
}

bool CurveFinder::follow(const glm::dvec3& start) {
    const TraceLimits limits{
        .longest_step = [this](const glm::dvec3& place) { return longest_step(place); },
        .shortest_step = 0.05 * limits_.smallest_pt / domain_.page.scale(start),
        .time = limits_.time};
    auto traced = trace_curve(system_, domain_, start, limits);
    if (!traced) return false;
    found_.report.stuck += static_cast<std::size_t>(traced->stuck_ends);
    index_.add(traced->curve, found_.curves.size());
    found_.curves.push_back(std::move(traced->curve));
    return true;
}

/// The offset that the curve reaches from one of its points, point by point towards higher offsets
/// (`sign` 1) or lower ones (-1), before it leaves the box; where the last step would leave it,
/// Newton's method looks on the plane that is wanted.
double CurveFinder::passed_one_way(const Passage& passage, const PlaceOnCurve& at, double sign,
                                   double wanted) const {
    const SpaceCurve& curve = found_.curves[at.curve];
    const auto count = static_cast<std::ptrdiff_t>(curve.points.size());
    auto i = static_cast<std::ptrdiff_t>(at.point);
    const CurvePoint* here = &curve.points[at.point];
    const int step = sign * glm::dot(here->tangent, passage.tangent) > 0.0 ? 1 : -1;
    double reached = passage.offset(here->place);
    for (std::ptrdiff_t walked = 1; walked < count && sign * (wanted - reached) > 0.0; ++walked) {
        i += step;
        if (curve.closed) i = (i + count) % count;
        if (i < 0 || i >= count || !passage.holds(curve.points[static_cast<std::size_t>(i)].place))
            break;
        here = &curve.points[static_cast<std::size_t>(i)];
        const double offset = passage.offset(here->place);
        if (sign * (offset - reached) < 0.0) return reached;
        reached = offset;
    }
    if (sign * (wanted - reached) <= 0.0) return reached;
    const double slope = glm::dot(here->tangent, passage.tangent);
    if (std::abs(slope) < 0.1) return reached;
    const double length = (wanted - reached) / slope;
    const auto there = system_.point_near(here->place + length * here->tangent, passage.tangent,
                                          0.5 * std::abs(length));
    return there && passage.holds(*there) ? wanted : reached;
}

Offsets CurveFinder::passed(const Passage& passage, const PlaceOnCurve& at,
                            const Offsets& wanted) const {
    return {.lo = passed_one_way(passage, at, -1.0, wanted.lo),
            .hi = passed_one_way(passage, at, 1.0, wanted.hi)};
}

bool CurveFinder::is_passed(const CurveCell& cell, const Passage& passage,
                            const Offsets& wanted) const {
    for (const PlaceOnCurve& at : index_.near(cell.place)) {
        if (!passage.holds(found_.curves[at.curve].points[at.point].place)) continue;
        if (passed(passage, at, wanted).cover(wanted)) return true;
    }
    return false;
}

void CurveFinder::settle(const CurveCell& cell, const Passage& passage, int divisions) {
    const Offsets wanted = offsets_of(passage, cell.box);
    if (is_passed(cell, passage, wanted)) return;
    const auto start = system_.point_near(cell.box.centre(), passage.tangent,
                                          glm::length(passage.around.hi - passage.around.lo));
    if (start && passage.holds(*start) && domain_.contains(*start)) {
        const double at = passage.offset(*start);
        if (!is_passed(cell, passage, {.lo = at, .hi = at}) && follow(*start) &&
            is_passed(cell, passage, wanted))
            return;
    }
    divide(cell, passage, divisions);
}

void CurveFinder::divide(const CurveCell& cell, const Passage& passage, int divisions) {
    const bool is_small = domain_.page.diameter(cell.box) <= limits_.smallest_pt;
    if (is_small || divisions >= most_divisions || limits_.time.over()) return leave_open(cell.box);
    std::vector<CurveCell> parts;
    for (const CellPlace& place : parts_of(domain_, cell.place)) {
        const Box box = box_of(domain_, place);
        if (domain_.may_contain(box)) parts.push_back({.place = place, .box = box});
    }
    const std::vector<JudgedCell> judged = judge_cells(system_, parts);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (judged[i].state != CellState::Empty) settle(parts[i], passage, divisions + 1);
    }
}

void CurveFinder::leave_open(const Box& box) {
    ++found_.report.open;
    found_.report.open_pt = std::max(found_.report.open_pt, domain_.page.diameter(box));
}

/// Follows a curve from an open cell where none was yet: nothing is proved of it.
void CurveFinder::try_open_cell(const CurveCell& cell) {
    if (!index_.near(cell.place).empty()) return;
    const auto start =
        system_.point_near(cell.box.centre(), glm::length(cell.box.hi - cell.box.lo));
    if (start && domain_.contains(*start) &&
        index_.near(place_of(domain_, cell.place.level, *start)).empty())
        follow(*start);
}

FoundCurves CurveFinder::run() {
    for (const CurveCell& cell : cells_.regular) {
        const Passage passage{
            .around = around(cell.box), .centre = cell.box.centre(), .tangent = cell.tangent};
        settle(cell, passage, 0);
    }
    std::size_t tries = 0;
    for (const CurveCell& cell : cells_.open) {
        leave_open(cell.box);
        if (tries++ < most_tries && !limits_.time.over()) try_open_cell(cell);
    }
    found_.report.cells = cells_.seen;
    found_.report.regular = cells_.regular.size();
    found_.report.in_time = !limits_.time.over();
    return std::move(found_);
}

}  // namespace

FindingReport& FindingReport::operator+=(const FindingReport& other) {
    cells += other.cells;
    regular += other.regular;
    open += other.open;
    open_pt = std::max(open_pt, other.open_pt);
    stuck += other.stuck;
    in_time = in_time && other.in_time;
    return *this;
}

FoundCurves find_curves(const CurveSystem& system, const CurveDomain& domain,
                        const SearchLimits& limits) {
    return CurveFinder(system, domain, limits).run();
}

}  // namespace zeroset
