#include "engine/trace/voxels/ray_cubic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

constexpr int most_cubic_halvings = 60;

/// f along a cubic, at a part t of the stretch.
double value_at(const std::array<double, 4>& b, double t) {
    const double s = 1 - t;
    return s * s * (s * b[0] + 3 * t * b[1]) + t * t * (3 * s * b[2] + t * b[3]);
}
double slope_at(const std::array<double, 4>& b, double t) {
    const double s = 1 - t;
    return 3 * (s * s * (b[1] - b[0]) + 2 * s * t * (b[2] - b[1]) + t * t * (b[3] - b[2]));
}

/// The sum of the coefficients times Bernstein's polynomials at t.
template <std::size_t count>
double bernstein_sum(const std::array<double, count>& b, double t) {
    std::array<double, count> of_s{};
    of_s[count - 1] = 1;
    for (std::size_t k = count - 1; k > 0; --k)
        of_s[k - 1] = of_s[k] * (1 - t);
    double sum = 0;
    double of_t = 1;  // C(n, k) t^k
    for (std::size_t k = 0; k < count; ++k) {
        sum += b[k] * of_t * of_s[k];
        of_t *= t * static_cast<double>(count - 1 - k) / static_cast<double>(k + 1);
    }
    return sum;
}
double value_at(const std::array<double, 10>& b, double t) { return bernstein_sum(b, t); }
double slope_at(const std::array<double, 10>& b, double t) {
    std::array<double, 9> steps{};
    for (std::size_t k = 0; k < steps.size(); ++k)
        steps[k] = 9 * (b[k + 1] - b[k]);
    return bernstein_sum(steps, t);
}

/// Both halves of a polynomial's stretch, by de Casteljau.
template <std::size_t count>
std::array<RayPolynomial<count>, 2> halves(const RayPolynomial<count>& of) {
    const double at = 0.5 * (of.from + of.to);
    std::array<RayPolynomial<count>, 2> result{
        RayPolynomial<count>{.b = {}, .from = of.from, .to = at},
        RayPolynomial<count>{.b = of.b, .from = at, .to = of.to}};
    auto& b = result[1].b;
    for (std::size_t k = 0; k < count; ++k) {
        result[0].b[k] = b[0];
        for (std::size_t i = 0; i + k + 1 < count; ++i)
            b[i] = 0.5 * (b[i] + b[i + 1]);
    }
    return result;
}

/// The root of f that goes from one side of 0 to the other without turning, by Newton's steps that
/// stay within the bracket.
template <std::size_t count>
double monotone_root(const std::array<double, count>& b) {
    constexpr int most_steps = 24;
    double lo = 0;
    double hi = 1;
    const bool falls = b[0] > 0;
    double t = b[0] / (b[0] - b[count - 1]);
    for (int i = 0; i < most_steps; ++i) {
        const double f = value_at(b, t);
        ((f > 0) == falls ? lo : hi) = t;
        const double next = t - f / slope_at(b, t);
        const double inside = next > lo && next < hi ? next : 0.5 * (lo + hi);
        // The next step would be as small as the square of this one.
        if (std::abs(inside - t) <= 1e-4) return inside;
        t = inside;
    }
    return t;
}

/// Whether the coefficients all rise, or all fall.
template <std::size_t count>
bool goes_one_way(const std::array<double, count>& b) {
    bool falls = true;
    bool rises = true;
    for (std::size_t k = 0; k + 1 < count; ++k) {
        falls = falls && b[k] > b[k + 1];
        rises = rises && b[k] < b[k + 1];
    }
    return falls || rises;
}

template <std::size_t count>
std::array<double, 2> least_and_largest(const std::array<double, count>& b) {
    double least = b[0];
    double largest = b[0];
    for (const double coefficient : b) {
        least = std::min(least, coefficient);
        largest = std::max(largest, coefficient);
    }
    return {least, largest};
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

template <std::size_t count>
bool FirstRoot::find_monotone(const RayPolynomial<count>& f) {
    const double width = f.to - f.from;
    const double t = monotone_root(f.b);
    // Make the bracket as wide as is allowed, so that signs are proved where f is flat.
    const double half = 0.49 * finest_ / width;
    const double t0 = std::max(0.0, t - half);
    const double t1 = std::min(1.0, t + half);
    const Side first = side_of(f.b[0]);
    const bool proved = (side_ == first || side_ == Side::Unknown) && !open_ &&
                        side_of(value_at(f.b, t0)) == first &&
                        side_of(value_at(f.b, t1)) == side_of(f.b[count - 1]);
    const double root = f.from + t * width;
    end(f.from + t0 * width, f.from + t1 * width, proved);
    depth_ = root;
    return true;
}

template <std::size_t count>
bool FirstRoot::look_at(const RayPolynomial<count>& f, int halvings) {
    const auto [least, largest] = least_and_largest(f.b);
    if (least > error_) return meet(Side::Above, f.from);
    if (largest < -error_) return meet(Side::Below, f.from);
    const Side first = side_of(f.b[0]);
    const Side last = side_of(f.b[count - 1]);
    const bool crosses = first != Side::Unknown && last != Side::Unknown && first != last;
    if (crosses && goes_one_way(f.b)) return meet(first, f.from) || find_monotone(f);
    if (f.to - f.from <= 0.25 * finest_ || halvings == most_cubic_halvings) {
        if (!open_) open_from_ = f.from;
        open_ = true;
        open_to_ = f.to;
        // An open stretch wider than a bracket ends the search.
        return f.to - open_from_ > finest_ && end(open_from_, f.to, false);
    }
    for (const RayPolynomial<count>& half : halves(f)) {
        if (look_at(half, halvings + 1)) return true;
    }
    return false;
}

template <std::size_t count>
bool FirstRoot::look_on(const RayPolynomial<count>& f) {
    if (open_ && f.from > open_to_) return finish();
    return look_at(f, 0);
}
bool FirstRoot::look(const RayCubic& f) { return look_on(f); }
bool FirstRoot::look(const RayNonic& f) { return look_on(f); }

bool FirstRoot::finish() { return open_ && end(open_from_, open_to_, false); }

}  // namespace zeroset
