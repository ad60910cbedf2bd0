#include "engine/antialias/half_square.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zeroset {
namespace {

/// The part of the square about the corner (-1, -1) in which max x' + min y' is at most `depth`,
/// x' and y' being the ways from the corner: at most half of the square. In ways from the corner.
SquarePart corner_part(double max, double min, double depth) {
    if (depth <= 2.0 * min) {
        const double x = depth / max;
        const double y = depth / min;
        return {.share = x * y / 8.0, .x = x / 3.0, .y = y / 3.0};
    }
    // Cut from side to side: `first` along the one, `last` along the other.
    const double per_max = 1.0 / max;
    const double first = depth * per_max;
    const double last = (depth - 2.0 * min) * per_max;
    const double sum = first + last;
    const double per_sum = 1.0 / (3.0 * sum);
    return {.share = sum / 4.0,
            .x = (first * first + first * last + last * last) * per_sum,
            .y = (2.0 * first + 4.0 * last) * per_sum};
}

}  // namespace

SquarePart SquarePart::rest() const {
    const double of_rest = 1.0 - share;
    if (!(of_rest > 0.0)) return {.share = 0.0, .x = 0.0, .y = 0.0};
    const double scale = -share / of_rest;
    return {.share = of_rest, .x = scale * x, .y = scale * y};
}

SquarePart part_below_zero(const LinearOnSquare& f) {
    // The smaller part: below 0 where f is above in the middle.
    const bool is_rest = !(f.value > 0.0);
    const double value = std::abs(f.value);
    const double by_x = std::abs(f.by_x);
    const double by_y = std::abs(f.by_y);
    const double depth = by_x + by_y - value;
    SquarePart part{.share = 0.0, .x = 0.0, .y = 0.0};
    if (depth > 0.0) {
        const bool along_x = by_x > by_y;
        part = corner_part(std::max(by_x, by_y), std::min(by_x, by_y), depth);
        if (!along_x) std::swap(part.x, part.y);
        // Place the part from the corner where f is least, or greatest.
        part.x = (f.by_x > 0.0) != is_rest ? part.x - 1.0 : 1.0 - part.x;
        part.y = (f.by_y > 0.0) != is_rest ? part.y - 1.0 : 1.0 - part.y;
    }
    return is_rest ? part.rest() : part;
}

}  // namespace zeroset
