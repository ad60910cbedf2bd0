#include "engine/noise/lattice_noise.hpp"

#include "engine/noise/cell_mean.hpp"
#include "engine/noise/noise_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

/// The most cells along an axis, and in all, that boxes are taken apart into.
constexpr int most_cells_on_axis = 4;
constexpr int most_cells = 8;

/// A part of a box in a cell.
struct BoxPart {
    std::array<std::uint32_t, 3> cell{};
    std::array<ValueBounds, 3> shares{};
};

/// Calls visit(part) for each cell that a box meets; false if there are too many.
bool for_each_part(const FieldBox& box, auto visit) {
    std::array<LatticeSpan, 3> spans;
    int cells = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        spans[i] = LatticeSpan::of(box.lo[i], box.hi[i], most_cells_on_axis);
        cells *= spans[i].cells;
    }
    if (cells == 0 || cells > most_cells) return false;
    for (int n = 0; n < cells; ++n) {
        const std::array<int, 3> of{n % spans[0].cells, n / spans[0].cells % spans[1].cells,
                                    n / (spans[0].cells * spans[1].cells)};
        BoxPart part;
        for (std::size_t i = 0; i < 3; ++i) {
            part.cell[i] = lattice_coordinate(spans[i].first + of[i]);
            part.shares[i] = {.lo = spans[i].from(box.lo[i], of[i]),
                              .hi = spans[i].to(box.hi[i], of[i])};
        }
        visit(part);
    }
    return true;
}

ValueBounds within(const ValueBounds& found, double error, double bound) {
    return {.lo = std::max(found.lo - error, -bound), .hi = std::min(found.hi + error, bound)};
}

FadeOrders along(std::size_t axis) {
    FadeOrders orders{};
    orders[axis] = 1;
    return orders;
}

constexpr ValueBounds nothing_yet{.lo = std::numeric_limits<double>::infinity(),
                                  .hi = -std::numeric_limits<double>::infinity()};

}  // namespace

/// Draws the corners of cells, those of the last one once.
class CellDrawer {
public:
    CellDrawer(NoiseKind kind, std::uint32_t start) : kind_(kind), start_(start) {}

    /// Writes the corners of a cell to lane `at`.
    template <std::size_t most>
    void draw(const std::array<std::uint32_t, 3>& cell, CornerLanes<most>& corners,
              std::size_t at) {
        find(cell);
        for (std::size_t c = 0; c < 8; ++c) {
            if (kind_ == NoiseKind::Value) {
                corners.number[c][at] = noise_number(hashes_[c]);
                continue;
            }
            std::array<double, 3> g{};
            for (std::size_t i = 0; i < 3; ++i)
                corners.gradient[i][c][at] = g[i] = noise_gradient(hashes_[c], i);
            corners.number[c][at] = number_of_gradient(c, g[0], g[1], g[2]);
        }
    }
    NoiseCell drawn(const std::array<std::uint32_t, 3>& cell) {
        CornerLanes<1> lane{};
        draw(cell, lane, 0);
        NoiseCell result;
        for (std::size_t c = 0; c < 8; ++c) {
            result.number[c] = lane.number[c][0];
            for (std::size_t i = 0; i < 3; ++i)
                result.gradient[i][c] = lane.gradient[i][c][0];
        }
        return result;
    }

private:
    void find(const std::array<std::uint32_t, 3>& cell) {
        if (any_ && cell == cell_) return;
        hashes_ = cell_hashes(start_, cell);
        cell_ = cell;
        any_ = true;
    }

    NoiseKind kind_;
    std::uint32_t start_;
    bool any_ = false;
    std::array<std::uint32_t, 3> cell_{};
    CellHashes hashes_{};
};

void LatticeNoise::at(std::span<const std::array<double, 3>> points, PointAnswer* answers) const {
    CellDrawer drawer(kind_, start_);
    NoisePoints lanes;
    lanes.count = points.size();
    for (std::size_t n = 0; n < points.size(); ++n) {
        const LatticePlace place = lattice_place(points[n]);
        drawer.draw(place.cell, lanes.corners, n);
        for (std::size_t i = 0; i < 3; ++i)
            lanes.share[i][n] = place.share[i];
    }
    mix_noise(lanes, has_gradients());
    for (std::size_t n = 0; n < points.size(); ++n) {
        answers[n].value = lanes.value[n];
        answers[n].slope = {lanes.slope[0][n], lanes.slope[1][n], lanes.slope[2][n]};
    }
}

PointAnswer LatticeNoise::at(const std::array<double, 3>& point, bool with_bends) const {
    PointAnswer answer;
    at(std::span(&point, 1), &answer);
    if (!with_bends) return answer;
    const LatticePlace place = lattice_place(point);
    const NoiseCell of = CellDrawer(kind_, start_).drawn(place.cell);
    const std::array<Fade, 3> fades{Fade(place.share[0]), Fade(place.share[1]),
                                    Fade(place.share[2])};
    Corners functions = of.number;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t c = 0; c < 8; ++c)
            functions[c] += of.gradient[i][c] * place.share[i];
    }
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            FadeOrders both = along(a);
            ++both[b];
            const double moved =
                mean_at(of.gradient[a], fades, along(b)) + mean_at(of.gradient[b], fades, along(a));
            answer.bend[a][b] = mean_at(functions, fades, both) + moved;
        }
    }
    return answer;
}

/// Collects parts of boxes, and encloses noise over as many as there is room for at once.
class LatticeNoise::Parts {
public:
    Parts(const LatticeNoise& noise, BoxAnswer* answers)
        : noise_(noise), answers_(answers), drawer_(noise.kind_, noise.start_) {
        lanes_.count = 0;
    }

    void add(const BoxPart& part, std::size_t box) {
        if (lanes_.count == NoiseParts::most) flush();
        const std::size_t at = lanes_.count++;
        box_[at] = box;
        drawer_.draw(part.cell, lanes_.corners, at);
        for (std::size_t i = 0; i < 3; ++i) {
            lanes_.from[i][at] = part.shares[i].lo;
            lanes_.to[i][at] = part.shares[i].hi;
        }
    }
    /// Adds what the parts are found to be to the hulls of their boxes.
    void flush() {
        enclose_noise(lanes_, noise_.has_gradients());
        for (std::size_t at = 0; at < lanes_.count; ++at) {
            BoxAnswer& answer = answers_[box_[at]];
            answer.value.add({.lo = lanes_.lo[at], .hi = lanes_.hi[at]});
            for (std::size_t i = 0; i < 3; ++i) {
                answer.slopes[i].add({.lo = lanes_.slope_lo[i][at], .hi = lanes_.slope_hi[i][at]});
            }
        }
        lanes_.count = 0;
    }

private:
    const LatticeNoise& noise_;
    BoxAnswer* answers_;
    CellDrawer drawer_;
    NoiseParts lanes_;
    std::array<std::size_t, NoiseParts::most> box_{};
};

void LatticeNoise::over(std::span<const FieldBox> boxes, BoxAnswer* answers) const {
    const NoiseBounds bounds = noise_bounds(kind_);
    const ValueBounds all{.lo = -bounds.value, .hi = bounds.value};
    const ValueBounds all_slopes{.lo = -bounds.slope, .hi = bounds.slope};
    Parts parts(*this, answers);
    for (std::size_t n = 0; n < boxes.size(); ++n) {
        answers[n] = {.value = nothing_yet,
                      .slopes = {nothing_yet, nothing_yet, nothing_yet},
                      .error = noise_error};
        const bool done = for_each_part(boxes[n], [&](const BoxPart& part) { parts.add(part, n); });
        if (done) continue;
        answers[n].value = all;
        answers[n].slopes.fill(all_slopes);
    }
    parts.flush();
    for (std::size_t n = 0; n < boxes.size(); ++n) {
        answers[n].value = within(answers[n].value, noise_error, bounds.value);
        for (ValueBounds& slope : answers[n].slopes)
            slope = within(slope, noise_slope_error, bounds.slope);
    }
}

BendAnswer LatticeNoise::bend(const FieldBox& box, const std::array<std::size_t, 2>& axes) const {
    const auto [a, b] = axes;
    const NoiseBounds bounds = noise_bounds(kind_);
    const double bound = a == b ? bounds.own_bend : bounds.mixed_bend;
    FadeOrders both = along(a);
    ++both[b];
    CellDrawer drawer(kind_, start_);
    ValueBounds all = nothing_yet;
    const bool done = for_each_part(box, [&](const BoxPart& part) {
        const NoiseCell of = drawer.drawn(part.cell);
        const auto fade = [&](std::size_t i) {
            return FadeRange(part.shares[i].lo, part.shares[i].hi);
        };
        const CellPart in_cell{.shares = part.shares, .fades = {fade(0), fade(1), fade(2)}};
        const MeanOver mean(of, in_cell);
        all.add(mean.of_functions(both) + mean.of_slopes(a, along(b)) +
                mean.of_slopes(b, along(a)));
    });
    if (!done) return {.value = {.lo = -bound, .hi = bound}};
    return {.value = within(all, noise_bend_error, bound)};
}

}  // namespace zeroset
