#include "engine/draw/curve_finder.hpp"

#include "engine/draw/curve_index.hpp"
#include "engine/draw/curve_tracer.hpp"

#include <algorithm>
#include <array>
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
constexpr int most_divisions = 12;
/// Open cells from which curves are tried to be found.
constexpr std::size_t most_tries = 4'000;

/// A regular cell's frame: planes across `tangent`, numbered by their distance from `centre`.
struct Passage {
    Box around;
    glm::dvec3 centre, tangent;

    [[nodiscard]] double offset(const glm::dvec3& point) const {
        return glm::dot(point - centre, tangent);
    }
    /// The rounding that places of points may have.
    [[nodiscard]] double slack() const { return 1e-9 * around.size(); }
    [[nodiscard]] bool holds(const glm::dvec3& point) const {
        return glm::all(glm::greaterThanEqual(point, around.lo - slack())) &&
               glm::all(glm::lessThanEqual(point, around.hi + slack()));
    }
};

/// The planes between two offsets.
struct Offsets {
    double lo, hi;
};

Offsets offsets_of(const Passage& passage, const Box& box) {
    const double middle = passage.offset(box.centre());
    const double half = 0.5 * glm::dot(glm::abs(passage.tangent), box.hi - box.lo);
    return {.lo = middle - half, .hi = middle + half};
}

/// The coarsest level of regular cells, and the finest of all.
struct Levels {
    int first = 0, last = 0;
};

Levels levels_of(const CurveCells& cells) {
    Levels levels;
    if (!cells.regular.empty()) levels.first = cells.regular.front().place.level;
    for (const std::vector<CurveCell>* list : {&cells.regular, &cells.open}) {
        for (const CurveCell& cell : *list)
            levels.last = std::max(levels.last, cell.place.level);
    }
    return levels;
}

class CurveFinder {
public:
    CurveFinder(const CurveSystem& system, const CurveDomain& domain, const SearchLimits& limits)
        : system_(system),
          domain_(domain),
          limits_(limits),
          cells_(find_cells(system, domain, limits.with_half_time())),
          levels_(levels_of(cells_)),
          index_(domain, levels_.first, levels_.last),
          last_level_(levels_.first) {
        for (std::size_t i = 0; i < cells_.regular.size(); ++i)
            regular_.emplace(key_of(cells_.regular[i].place), i);
    }

    FoundCurves run();

private:
    [[nodiscard]] std::optional<double> cell_step(const glm::dvec3& place);
    [[nodiscard]] double longest_step(const glm::dvec3& place);
    void settle(const CurveCell& cell, const Passage& passage, int divisions);
    void divide(const CurveCell& cell, const Passage& passage, int divisions);
    void leave_open(const Box& box);
    void try_open_cell(const CurveCell& cell);
    bool follow(const glm::dvec3& start);
    /// Whether a followed curve, from one of its points on, gets to the plane at this offset before
    /// it leaves the passage's box; `sign` 1: towards higher offsets.
    [[nodiscard]] bool reaches(const Passage& passage, const PlaceOnCurve& at, double sign,
                               double wanted) const;
    [[nodiscard]] glm::dvec3 point_at(const PlaceOnCurve& at) const;
    [[nodiscard]] bool is_followed(const glm::dvec3& point);
    [[nodiscard]] bool is_known(const SpaceCurve& curve);
    [[nodiscard]] bool is_singular(const glm::dvec3& point, const Box& cell) const;
    [[nodiscard]] bool is_passed(const CurveCell& cell, const Passage& passage,
                                 const Offsets& wanted);

    const CurveSystem& system_;
    const CurveDomain& domain_;
    const SearchLimits& limits_;
    CurveCells cells_;
    Levels levels_;
    std::unordered_map<std::uint64_t, std::size_t> regular_;
    CurveIndex index_;
    FoundCurves found_;
    int last_level_;                  ///< where cell_step looks first
    std::vector<PlaceOnCurve> near_;  ///< room for answers of the index
};

/// How far a step may go from a place in a regular cell.
std::optional<double> CurveFinder::cell_step(const glm::dvec3& place) {
    // The next place is mostly in a cell of the last one's level.
    const int levels = levels_.last - levels_.first + 1;
    for (int i = 0; i < levels; ++i) {
        const int level = levels_.first + (last_level_ - levels_.first + i) % levels;
        const auto cell = regular_.find(key_of(place_of(domain_, level, place)));
        if (cell == regular_.end()) continue;
        last_level_ = level;
        const Box& box = cells_.regular[cell->second].box;
        double least = box.size();
        for (int axis = 0; axis < 3; ++axis) {
            if (!domain_.is_flat(axis)) least = std::min(least, box.hi[axis] - box.lo[axis]);
        }
        return step_part * least;
    }
    return std::nullopt;
}

double CurveFinder::longest_step(const glm::dvec3& place) {
    return cell_step(place).value_or(1.0 / domain_.page.scale(place));
}

bool CurveFinder::follow(const glm::dvec3& start) {
    const TraceLimits limits{
        .longest_step = [this](const glm::dvec3& place) { return longest_step(place); },
        .shortest_step = 0.05 * limits_.smallest_pt / domain_.page.scale(start),
        .time = limits_.time};
    auto traced = trace_curve(system_, domain_, start, limits);
    if (!traced || is_known(traced->curve)) return false;
    found_.report.stuck += static_cast<std::size_t>(traced->stuck_ends);
    const double least = 4.0 * limits_.smallest_pt / domain_.page.scale(start);
    index_.add(traced->curve, found_.curves.size(),
               [&](const glm::dvec3& place) { return cell_step(place).value_or(least); });
    found_.curves.push_back(std::move(traced->curve));
    return true;
}

/// The next point of a curve in a direction, 1 or -1; nothing beyond its ends.
std::optional<std::size_t> next_point(const SpaceCurve& curve, std::size_t point, int step) {
    const std::size_t count = curve.points.size();
    if (step > 0) {
        if (point + 1 < count) return point + 1;
        return curve.closed ? std::optional<std::size_t>(0) : std::nullopt;
    }
    if (point > 0) return point - 1;
    return curve.closed ? std::optional(count - 1) : std::nullopt;
}

glm::dvec3 CurveFinder::point_at(const PlaceOnCurve& at) const {
    const SpaceCurve& curve = found_.curves[at.curve];
    const auto next = next_point(curve, at.point, 1);
    if (!next || at.share == 0.0) return curve.points[at.point].place;
    return between(curve.points[at.point], curve.points[*next], at.share);
}

// Goes from point to point; where the next one is outside of the box, Newton's method looks for one
// on the wanted plane.
bool CurveFinder::reaches(const Passage& passage, const PlaceOnCurve& at, double sign,
                          double wanted) const {
    const SpaceCurve& curve = found_.curves[at.curve];
    CurvePoint here{.place = point_at(at), .tangent = curve.points[at.point].tangent};
    const int step = sign * glm::dot(here.tangent, passage.tangent) > 0.0 ? 1 : -1;
    const auto missing = [&](const glm::dvec3& point) {
        return sign * (wanted - passage.offset(point)) - passage.slack();
    };
    double left = missing(here.place);
    auto next =
        step < 0 && at.share > 0.0 ? std::optional(at.point) : next_point(curve, at.point, step);
    while (left > 0.0 && next && passage.holds(curve.points[*next].place)) {
        here = curve.points[*next];
        const double then = missing(here.place);
        if (then >= left) return false;
        left = then;
        next = next_point(curve, *next, step);
    }
    if (left <= 0.0) return true;
    const double slope = glm::dot(here.tangent, passage.tangent);
    if (std::abs(slope) < 0.1) return false;
    const double length = (wanted - passage.offset(here.place)) / slope;
    const auto there = system_.point_near(here.place + length * here.tangent, passage.tangent,
                                          0.5 * std::abs(length) + 10.0 * passage.slack());
    return there && passage.holds(*there);
}

bool CurveFinder::is_passed(const CurveCell& cell, const Passage& passage, const Offsets& wanted) {
    std::optional<PlaceOnCurve> last;
    index_.near(cell.place, near_);
    for (const PlaceOnCurve& at : near_) {
        if (!passage.holds(point_at(at))) continue;
        const bool goes_on =
            last && last->curve == at.curve && at.point - last->point <= std::size_t{1};
        if (!goes_on && reaches(passage, at, -1.0, wanted.lo) &&
            reaches(passage, at, 1.0, wanted.hi))
            return true;
        last = at;
    }
    return false;
}

void CurveFinder::settle(const CurveCell& cell, const Passage& passage, int divisions) {
    if (limits_.time.over()) return leave_open(cell.box);
    const Offsets wanted = offsets_of(passage, cell.box);
    if (is_passed(cell, passage, wanted)) return;
    const auto start = system_.point_near(cell.box.centre(), passage.tangent,
                                          glm::length(passage.around.hi - passage.around.lo));
    if (start && passage.holds(*start) && domain_.contains(*start)) {
        const double at = passage.offset(*start);
        const bool is_new = !is_passed(cell, passage, {.lo = at, .hi = at}) && !is_followed(*start);
        if (is_new && follow(*start) && is_passed(cell, passage, wanted)) return;
    }
    divide(cell, passage, divisions);
}

void CurveFinder::divide(const CurveCell& cell, const Passage& passage, int divisions) {
    const bool is_small = domain_.page.diameter(cell.box) <= limits_.smallest_pt;
    if (is_small || divisions >= most_divisions || limits_.time.over()) return leave_open(cell.box);
    std::vector<CurveCell> parts;
    for (const CellPlace& place : parts_of(domain_, cell.place))
        parts.push_back({.place = place, .box = box_of(domain_, place)});
    parts = sifted(system_, domain_, limits_.time, std::move(parts));
    const std::vector<JudgedCell> judged = judge_cells(system_, parts, limits_.time);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (judged[i].state != CellState::Empty) settle(parts[i], passage, divisions + 1);
    }
}

void CurveFinder::leave_open(const Box& box) {
    ++found_.report.open;
    found_.report.open_pt = std::max(found_.report.open_pt, domain_.page.diameter(box));
}

/// Whether a point of the curve is on one that was followed: between two points of that, where
/// Newton's method from the cubic between them finds it again.
bool CurveFinder::is_followed(const glm::dvec3& point) {
    constexpr double aside = 0.05;    // in ways from a point of a curve to the next
    constexpr double reach_pt = 4.0;  // a bound of those
    int level = levels_.last;
    while (level > levels_.first &&
           domain_.page.diameter(box_of(domain_, place_of(domain_, level, point))) < reach_pt)
        --level;
    const auto is_between = [&](const CurvePoint& a, const CurvePoint& b) {
        const double length = glm::distance(a.place, b.place);
        const glm::dvec3 chord = (b.place - a.place) / length;
        const double share = glm::dot(point - a.place, chord) / length;
        if (!(share >= -aside && share <= 1.0 + aside)) return false;
        glm::dvec3 start = between(a, b, share);
        start += glm::dot(point - start, chord) * chord;
        if (glm::distance(start, point) > aside * length) return false;
        const auto again = system_.point_near(start, chord, aside * length);
        return again && glm::distance(*again, point) <= 1e-4 * length;
    };
    std::optional<PlaceOnCurve> last;
    index_.near(place_of(domain_, level, point), near_);
    for (const PlaceOnCurve& at : near_) {
        const bool is_again = last && last->curve == at.curve && last->point == at.point;
        last = at;
        const SpaceCurve& curve = found_.curves[at.curve];
        const auto next = is_again ? std::nullopt : next_point(curve, at.point, 1);
        if (next && is_between(curve.points[at.point], curve.points[*next])) return true;
    }
    return false;
}

/// Whether a curve is a followed one but for its ends.
bool CurveFinder::is_known(const SpaceCurve& curve) {
    const std::size_t count = curve.points.size();
    return std::ranges::all_of(std::array{count / 4, count / 2, count - 1 - count / 4},
                               [&](std::size_t i) { return is_followed(curve.points[i].place); });
}

/// Follows a curve from an open cell where none was yet: nothing is proved of it.
void CurveFinder::try_open_cell(const CurveCell& cell) {
    const auto start =
        system_.point_near(cell.box.centre(), glm::length(cell.box.hi - cell.box.lo));
    if (start && domain_.contains(*start) && !is_singular(*start, cell.box) && !is_followed(*start))
        follow(*start);
}

/// Whether both equations vanish there to first order beside what they are at the cell's corner: so
/// on curves on which a surface meets itself.
bool CurveFinder::is_singular(const glm::dvec3& point, const Box& cell) const {
    constexpr double part = 1e-3;
    const Linearized there = system_.at(point);
    const Linearized aside = system_.at(cell.hi);
    return !(glm::length(there.gradients[0]) > part * glm::length(aside.gradients[0]));
}

FoundCurves CurveFinder::run() {
    for (const CurveCell& cell : cells_.regular) {
        const Passage passage{
            .around = around(cell.box), .centre = cell.box.centre(), .tangent = cell.tangent};
        settle(cell, passage, 0);
    }
    const std::size_t stride = cells_.open.size() / most_tries + 1;
    for (std::size_t i = 0; i < cells_.open.size(); ++i) {
        leave_open(cells_.open[i].box);
        if (i % stride == 0 && !limits_.time.over()) try_open_cell(cells_.open[i]);
    }
    found_.report.cells = cells_.seen;
    found_.report.singular = cells_.singular;
    found_.report.regular = cells_.regular.size();
    found_.report.in_time = cells_.in_time && !limits_.time.over();
    return std::move(found_);
}

}  // namespace

FindingReport& FindingReport::operator+=(const FindingReport& other) {
    cells += other.cells;
    regular += other.regular;
    open += other.open;
    singular += other.singular;
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
