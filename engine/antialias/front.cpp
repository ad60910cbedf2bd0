#include "engine/antialias/front.hpp"

#include <algorithm>

namespace zeroset {
namespace {

constexpr int most_open_cells = 8;
/// How much longer than the cell before it a cell is at most, and how much shorter.
constexpr double most_growth = 4.0;
constexpr double least_growth = 0.125;
/// Roots that lie in fewer fair lengths are looked for in one cell.
constexpr double most_fair_lengths = 8.0;

}  // namespace

void Front::pass() {
    at = to;
    open_from = none;
    state = at < end ? State::Going : State::Gone;
}

void Front::end_stretch(double until) {
    state = State::Edged;
    to = until;
    at = open_from;
}

void Front::leave_open(const CellVerdict& cell) {
    if (!is_open()) {
        open_from = at;
        open_cells = 0;
        continuous = true;
        kinked = false;
    }
    continuous = continuous && cell.continuous;
    kinked = kinked || cell.kinked;
    stretched = false;
    at = cell.to;
    if (++open_cells >= most_open_cells || at >= end) end_stretch(at);
}

void Front::take_root(const CellVerdict& cell, const FrontRules& rules) {
    const double width = cell.root_to - cell.root_from;
    const double length = cell.to - cell.from;
    if (!cell.monotone && length > 2.0 * rules.fair_length) {
        // There may be several roots on a ray, of which the first is wanted.
        step = 0.5 * length;
        return;
    }
    if (cell.turn > most_turn_of(cell.kinked) && length > 3.0 * (width + rules.margin)) {
        // A long cell tells more of f beside the sheet than of the sheet.
        const double spare = 0.25 * width + rules.margin;
        at = std::max(cell.from, cell.root_from - spare);
        step = cell.root_to + spare - at;
        return;
    }
    state = State::Rooted;
    at = cell.root_from;
    to = cell.root_to;
    turn = cell.turn;
    monotone = cell.monotone;
    kinked = cell.kinked;
}

void Front::advance(const CellVerdict& cell, const FrontRules& rules) {
    const double length = cell.to - cell.from;
    if (cell.rejected) {
        if (is_open()) return end_stretch(at);
        at = cell.to;
        step = std::clamp(cell.growth, 1.0, most_growth) * length;
        stretched = false;
        if (at >= end) state = State::Gone;
        return;
    }
    const bool begins = cell.root_from > cell.from;
    const bool ends = cell.root_to < cell.to;
    if (cell.continuous && begins && ends && is_inside(cell.root_from, cell.root_to)) {
        // So far before the roots that the next cell holds them, too.
        const double spare = cell.root_to - cell.root_from + rules.margin;
        kinked = kinked || cell.kinked;
        if (is_open()) return end_stretch(std::max(cell.from, cell.root_from - spare));
        return take_root(cell, rules);
    }
    if (!cell.precise && length > 1.5 * rules.fair_length) {
        step = std::max(std::clamp(cell.growth, least_growth, 0.5) * length, rules.fair_length);
        return;
    }
    // Make a cell longer that all rays seem to leave with a root.
    const double width = cell.root_to - cell.root_from;
    const bool grows = begins && !ends && cell.precise && !stretched && cell.to < end &&
                       width < most_fair_lengths * rules.fair_length;
    if (!grows) return leave_open(cell);
    step = cell.root_to - at + 0.25 * width + rules.margin;
    stretched = true;
}

}  // namespace zeroset
