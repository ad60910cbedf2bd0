#include "engine/draw/curve_cells.hpp"

#include "engine/base/parallel.hpp"
#include "engine/draw/curve_index.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <utility>

namespace zeroset {
namespace {

/// Cells of a domain that is larger on the page than this part of it are always divided.
constexpr double largest_part = 1.0 / 6.0;
constexpr int deepest_level = 20;

bool misses(const Ball& ball, const Box& cell) {
    const glm::dvec3 nearest = glm::clamp(ball.centre, cell.lo, cell.hi);
    return glm::distance(nearest, ball.centre) > ball.radius * (1.0 + 1e-9);
}

bool misses(const Section& section, const Box& cell) {
    const glm::dvec3 half = 0.5 * (cell.hi - cell.lo);
    const double least =
        glm::dot(section.normal, cell.centre()) - glm::dot(glm::abs(section.normal), half);
    return least > section.offset + 1e-9 * (std::abs(section.offset) + glm::length(half));
}

/// Calls `body` with the first and the count of some of so many items at a time, on all cores.
void in_chunks(std::size_t items, const std::function<void(std::size_t, std::size_t)>& body) {
    constexpr std::size_t at_once = 256;
    parallel_for((items + at_once - 1) / at_once, 0, [&](std::size_t chunk) {
        const std::size_t first = chunk * at_once;
        body(first, std::min(at_once, items - first));
    });
}

/// The search by halving, level by level.
class CellSearch {
public:
    CellSearch(const CurveSystem& system, const CurveDomain& domain, const SearchLimits& limits)
        : system_(system), domain_(domain), limits_(limits), singular_(singular_index()) {}

    CurveCells run() {
        cells_ = {{.place = {}, .box = domain_.box}};
        while (!cells_.empty()) {
            cells_ = sifted(system_, domain_, limits_.time, std::move(cells_));
            result_.seen += cells_.size();
            judge();
            divide();
        }
        return std::move(result_);
    }

private:
    void judge();
    void divide();
    [[nodiscard]] CurveIndex singular_index() const;
    [[nodiscard]] bool is_singular(const CurveCell& cell, double diameter_pt) const {
        return diameter_pt <= limits_.singular_pt && !limits_.singular.empty() &&
               singular_.has_near(cell.place);
    }

    const CurveSystem& system_;
    const CurveDomain& domain_;
    const SearchLimits& limits_;
    CurveIndex singular_;
    std::vector<CurveCell> cells_;
    CurveCells result_;
};

CurveIndex CellSearch::singular_index() const {
    const double cells = domain_.page.diameter(domain_.box) / limits_.singular_pt;
    const double level = std::isfinite(cells) ? std::ceil(std::log2(std::max(cells, 1.0))) : 12.0;
    CurveIndex index(domain_, 0, static_cast<int>(std::min(level, 12.0)));
    for (std::size_t i = 0; i < limits_.singular.size(); ++i) {
        index.add(*limits_.singular[i], i, [&](const glm::dvec3& place) {
            return 0.5 * limits_.singular_pt / domain_.page.scale(place);
        });
    }
    return index;
}

/// Keeps the cells that are open still, takes the regular ones.
void CellSearch::judge() {
    const PageSize& page = domain_.page.size();
    const double largest = largest_part * std::min(page.width, page.height);
    std::vector<CurveCell> large;
    std::vector<CurveCell> small;
    for (const CurveCell& cell : cells_)
        (domain_.page.diameter(cell.box) > largest ? large : small).push_back(cell);
    const std::vector<JudgedCell> judged = judge_cells(system_, small, limits_.time);
    cells_ = std::move(large);
    for (std::size_t i = 0; i < small.size(); ++i) {
        small[i].tangent = judged[i].tangent;
        if (judged[i].state == CellState::Regular) result_.regular.push_back(small[i]);
        if (judged[i].state == CellState::Open) cells_.push_back(small[i]);
    }
}

void CellSearch::divide() {
    const bool is_full = cells_.size() > limits_.most_cells || limits_.time.over();
    result_.in_time = result_.in_time && !limits_.time.over();
    std::vector<CurveCell> parts;
    for (const CurveCell& cell : cells_) {
        const double diameter = domain_.page.diameter(cell.box);
        if (is_singular(cell, diameter)) {
            ++result_.singular;
            continue;
        }
        const bool is_small = diameter <= limits_.smallest_pt;
        if (is_full || is_small || cell.place.level >= deepest_level) {
            result_.open.push_back(cell);
            continue;
        }
        for (const CellPlace& part : parts_of(domain_, cell.place))
            parts.push_back({.place = part, .box = box_of(domain_, part)});
    }
    cells_ = std::move(parts);
}

}  // namespace

bool CurveDomain::contains(const glm::dvec3& point) const {
    const double slack = 1e-11 * (box.size() + glm::length(point));
    for (int axis = 0; axis < 3; ++axis) {
        if (!(point[axis] >= box.lo[axis] - slack && point[axis] <= box.hi[axis] + slack))
            return false;
    }
    return page.shows(point);
}

bool CurveDomain::may_contain(const Box& cell) const {
    if (!page.may_show(cell)) return false;
    if (region.ball && misses(*region.ball, cell)) return false;
    return std::ranges::none_of(region.sections,
                                [&](const Section& section) { return misses(section, cell); });
}

std::uint64_t key_of(const CellPlace& place) {
    std::uint64_t key = static_cast<std::uint64_t>(place.level);
    for (int axis = 0; axis < 3; ++axis)
        key = key << 20U | static_cast<std::uint64_t>(place.at[axis]);
    return key;
}

CellPlace place_of(const CurveDomain& domain, int level, const glm::dvec3& point) {
    CellPlace place{.level = level};
    const double cells = std::ldexp(1.0, level);
    for (int axis = 0; axis < 3; ++axis) {
        if (domain.is_flat(axis)) continue;
        const double share =
            (point[axis] - domain.box.lo[axis]) / (domain.box.hi[axis] - domain.box.lo[axis]);
        place.at[axis] = static_cast<int>(std::clamp(std::floor(share * cells), 0.0, cells - 1.0));
    }
    return place;
}

Box box_of(const CurveDomain& domain, const CellPlace& place) {
    Box box = domain.box;
    const double part = std::ldexp(1.0, -place.level);
    const glm::dvec3 size = domain.box.hi - domain.box.lo;
    for (int axis = 0; axis < 3; ++axis) {
        if (domain.is_flat(axis)) continue;
        box.lo[axis] = domain.box.lo[axis] + size[axis] * part * place.at[axis];
        box.hi[axis] = domain.box.lo[axis] + size[axis] * part * (place.at[axis] + 1);
    }
    return box;
}

Box around(const Box& box) {
    const glm::dvec3 more = 0.5 * (box.hi - box.lo);
    return {.lo = box.lo - more, .hi = box.hi + more};
}

std::vector<CellPlace> parts_of(const CurveDomain& domain, const CellPlace& place) {
    std::vector<CellPlace> parts;
    for (int octant = 0; octant < 8; ++octant) {
        CellPlace part{.level = place.level + 1, .at = 2 * place.at};
        bool wanted = true;
        for (int axis = 0; axis < 3; ++axis) {
            const int upper = octant >> axis & 1;
            if (domain.is_flat(axis)) {
                part.at[axis] = 0;
                wanted = wanted && upper == 0;
            } else {
                part.at[axis] += upper;
            }
        }
        if (wanted) parts.push_back(part);
    }
    return parts;
}

std::vector<CurveCell> sifted(const CurveSystem& system, const CurveDomain& domain,
                              const TimeLimit& time, std::vector<CurveCell> cells) {
    std::erase_if(cells, [&](const CurveCell& cell) { return !domain.may_contain(cell.box); });
    std::vector<Box> boxes;
    boxes.reserve(cells.size());
    for (const CurveCell& cell : cells)
        boxes.push_back(cell.box);
    const auto may = std::make_unique<bool[]>(cells.size());
    in_chunks(cells.size(), [&](std::size_t first, std::size_t count) {
        const std::span<bool> some(may.get() + first, count);
        if (time.over()) {
            std::ranges::fill(some, true);
        } else {
            system.sift(std::span(boxes).subspan(first, count), some);
        }
    });
    std::vector<CurveCell> kept;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (may[i]) kept.push_back(cells[i]);
    }
    return kept;
}

std::vector<JudgedCell> judge_cells(const CurveSystem& system, const std::vector<CurveCell>& cells,
                                    const TimeLimit& time) {
    std::vector<Box> boxes;
    std::vector<Box> wider;
    for (const CurveCell& cell : cells) {
        boxes.push_back(cell.box);
        wider.push_back(around(cell.box));
    }
    std::vector<JudgedCell> judged(cells.size());
    in_chunks(cells.size(), [&](std::size_t first, std::size_t count) {
        if (time.over()) return;
        system.judge(std::span(boxes).subspan(first, count), std::span(wider).subspan(first, count),
                     std::span(judged).subspan(first, count));
    });
    return judged;
}

SearchLimits SearchLimits::with_half_time() const {
    SearchLimits half = *this;
    if (time.until != TimeLimit::never) {
        const auto now = TimeLimit::Clock::now();
        half.time.until = now + (time.until - now) / 2;
    }
    return half;
}

CurveCells find_cells(const CurveSystem& system, const CurveDomain& domain,
                      const SearchLimits& limits) {
    return CellSearch(system, domain, limits).run();
}

}  // namespace zeroset
