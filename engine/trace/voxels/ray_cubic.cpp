#include "engine/trace/voxels/ray_cubic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

constexpr int most_halvings = 60;

/// f along a cubic, at a part t of the stretch.
double value_at(const std::array<double, 4>& b, double t) {
    const double s = 1 - t;
    return s * s * (s * b[0] + 3 * t * b[1]) + t * t * (3 * s * b[2] + t * b[3]);
}

std::array<RayCubic, 2> halves(const RayCubic& of) {
    const auto& b = of.b;
    const auto mean = [](double x, double y) { return 0.5 * (x + y); };
    const std::array first{mean(b[0], b[1]), mean(b[1], b[2]), mean(b[2], b[3])};
    const std::array second{mean(first[0], first[1]), mean(first[1], first[2])};
    const double middle = mean(second[0], second[1]);
    const double at = mean(of.from, of.to);
    return {RayCubic{.b = {b[0], first[0], second[0], middle}, .from = of.from, .to = at},
            RayCubic{.b = {middle, second[1], first[2], b[3]}, .from = at, .to = of.to}};
}

/// Where a cubic that goes from one side of 0 to the other without turning is 0, by Newton's steps
/// that stay within the bracket.
double monotone_root(const std::array<double, 4>& b) {
    constexpr int most_steps = 24;
    double lo = 0;
    double hi = 1;
    const bool falls = b[0] > 0;
    double t = b[0] / (b[0] - b[3]);
    for (int i = 0; i < most_steps; ++i) {
        const double f = value_at(b, t);
        ((f > 0) == falls ? lo : hi) = t;
        const double s = 1 - t;
        const double slope =
            3 * (s * s * (b[1] - b[0]) + 2 * s * t * (b[2] - b[1]) + t * t * (b[3] - b[2]));
        const double next = t - f / slope;
        const double inside = next > lo && next < hi ? next : 0.5 * (lo + hi);
        // The next step would be as small as the square of this one.
        if (std::abs(inside - t) <= 1e-4) return inside;
        t = inside;
    }
    return t;
}

}  // namespace

/// The coefficients are means of f with the three places at either end [the polar form].
RayCubic ray_cubic(const CellCorners& corners, const std::array<double, 3>& at_from,
                   const std::array<double, 3>& at_to, double from, double to) {
    const auto mix = [](double x, double y, double share) { return x + share * (y - x); };
    // Along the first axis at both ends, then along the second, then along the third
    std::array<std::array<double, 2>, 4> edges{};
    for (std::size_t edge = 0; edge < 4; ++edge) {
        edges[edge] = {mix(corners[2 * edge], corners[2 * edge + 1], at_from[0]),
                       mix(corners[2 * edge], corners[2 * edge + 1], at_to[0])};
    }
    std::array<double, 8> ends{};  // bits as in CellCorners: set where an axis is at its end
    for (std::size_t x = 0; x < 2; ++x) {
        for (std::size_t y = 0; y < 2; ++y) {
            const double share = y == 0 ? at_from[1] : at_to[1];
            const double below = mix(edges[0][x], edges[1][x], share);
            const double above = mix(edges[2][x], edges[3][x], share);
            ends[x + 2 * y] = mix(below, above, at_from[2]);
            ends[x + 2 * y + 4] = mix(below, above, at_to[2]);
        }
    }
    constexpr double third = 1.0 / 3.0;
    return {.b = {ends[0], third * (ends[1] + ends[2] + ends[4]),
                  third * (ends[3] + ends[5] + ends[6]), ends[7]},
            .from = from,
            .to = to};
}

std::array<double, 3> cell_slopes(const CellCorners& corners, const std::array<double, 3>& at) {
    const auto mix = [](double x, double y, double share) { return x + share * (y - x); };
    std::array<double, 4> edge{};
    std::array<double, 4> slope{};
    for (std::size_t i = 0; i < 4; ++i) {
        slope[i] = corners[2 * i + 1] - corners[2 * i];
        edge[i] = corners[2 * i] + at[0] * slope[i];
    }
    return {mix(mix(slope[0], slope[1], at[1]), mix(slope[2], slope[3], at[1]), at[2]),
            mix(edge[1] - edge[0], edge[3] - edge[2], at[2]),
            mix(edge[2], edge[3], at[1]) - mix(edge[0], edge[1], at[1])};
}

auto FirstRoot::side_of(double value) const -> Side {
    return value > error_ ? Side::Above : value < -error_ ? Side::Below : Side::Unknown;
}

bool FirstRoot::end(double from, double to, bool proved) {
    from_ = from;
    to_ = to;
    depth_ = 0.5 * (from + to);
    proved_ = proved;
    return true;
}

bool FirstRoot::meet(Side side, double from) {
    const bool was_open = open_;
    open_ = false;
    if (!was_open) {
        // Between stretches f is not near 0, so the side has not changed since.
        if (side_ != Side::Unknown && side_ != side) return end(from, from, false);
        side_ = side;
        return false;
    }
    const bool crossed = side_ != Side::Unknown && side_ != side;
    return end(open_from_, from, crossed && from - open_from_ <= finest_);
}

bool FirstRoot::find_monotone(const RayCubic& cubic) {
    const double width = cubic.to - cubic.from;
    const double t = monotone_root(cubic.b);
    // As wide as is allowed, so that signs are proved where f is flat.
    const double half = 0.49 * finest_ / width;
    const double t0 = std::max(0.0, t - half);
    const double t1 = std::min(1.0, t + half);
    const Side first = side_of(cubic.b[0]);
    const bool proved = (side_ == first || side_ == Side::Unknown) && !open_ &&
                        side_of(value_at(cubic.b, t0)) == first &&
                        side_of(value_at(cubic.b, t1)) == side_of(cubic.b[3]);
    const double root = cubic.from + t * width;
    end(cubic.from + t0 * width, cubic.from + t1 * width, proved);
    depth_ = root;
    return true;
}

bool FirstRoot::look_at(const RayCubic& cubic, int halvings) {
    const auto& b = cubic.b;
    const auto [least, largest] = std::minmax({b[0], b[1], b[2], b[3]});
    if (least > error_) return meet(Side::Above, cubic.from);
    if (largest < -error_) return meet(Side::Below, cubic.from);
    const Side first = side_of(b[0]);
    const Side last = side_of(b[3]);
    if (first != Side::Unknown && last != Side::Unknown && first != last) {
        const bool falls = b[0] > b[1] && b[1] > b[2] && b[2] > b[3];
        const bool rises = b[0] < b[1] && b[1] < b[2] && b[2] < b[3];
        if (falls || rises) return meet(first, cubic.from) || find_monotone(cubic);
    }
    if (cubic.to - cubic.from <= 0.25 * finest_ || halvings == most_halvings) {
        if (!open_) open_from_ = cubic.from;
        open_ = true;
        open_to_ = cubic.to;
        // An open stretch wider than a bracket ends the search.
        return cubic.to - open_from_ > finest_ && end(open_from_, cubic.to, false);
    }
    for (const RayCubic& half : halves(cubic)) {
        if (look_at(half, halvings + 1)) return true;
    }
    return false;
}

bool FirstRoot::look(const RayCubic& cubic) {
    if (open_ && cubic.from > open_to_) return finish();
    return look_at(cubic, 0);
}

bool FirstRoot::finish() { return open_ && end(open_from_, open_to_, false); }

}  // namespace zeroset
