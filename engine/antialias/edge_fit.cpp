#include "engine/antialias/edge_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

struct HeightLine {
    LinearOnSquare fit;
    double off;  ///< twice what heights differ from it
};

HeightLine line_through(const std::array<double, square_ray_count>& h) {
    const double mean = 0.25 * (h[1] + h[2] + h[3] + h[4]);
    const double twist = 0.25 * std::abs(h[1] + h[4] - h[2] - h[3]);
    // The mean over the square is that of the quadratic function through the heights.
    return {.fit = {.value = h[0] + 4.0 / 3.0 * (mean - h[0]),
                    .by_x = 0.5 * (h[2] + h[4] - h[1] - h[3]),
                    .by_y = 0.5 * (h[3] + h[4] - h[1] - h[2])},
            .off = 2.0 * (twist + std::abs(mean - h[0]))};
}

/// The sign of numbers, one at each ray of a square, all over the square: where they go linearly
/// with the place; 0: not known.
int sign_over_square(const std::array<double, square_ray_count>& numbers) {
    double change = 0.0;
    for (const double number : numbers)
        change = std::max(change, std::abs(number - numbers[0]));
    // Corners are twice as far from the middle as the other rays; walls may meet on the way there.
    if (!(std::abs(numbers[0]) > 3.0 * change)) return 0;
    return numbers[0] > 0.0 ? 1 : -1;
}

/// The sign that heights keep all over the square; 0: not known.
int sign_of_line(const HeightLine& line) {
    const LinearOnSquare& fit = line.fit;
    const double least = std::abs(fit.value) - std::abs(fit.by_x) - std::abs(fit.by_y);
    if (!(least > 2.0 * line.off)) return 0;
    return fit.value > 0.0 ? 1 : -1;
}

/// The plane through one end of stretches: the depths over the square.
HeightLine plane_through(SquareStretches stretches, double RayStretch::* end) {
    std::array<double, square_ray_count> depth{};
    for (std::size_t i = 0; i < square_ray_count; ++i)
        depth[i] = stretches[i].*end;
    return line_through(depth);
}

/// Whether one end of stretches is as deep over the square as a plane is.
bool is_even(SquareStretches stretches, CornerStretches corners, double RayStretch::* end) {
    constexpr double most = 1.0 / 32;  // in parts of how its depth changes
    const HeightLine plane = plane_through(stretches, end);
    const double change = most * (std::abs(plane.fit.by_x) + std::abs(plane.fit.by_y));
    if (!(plane.off <= change)) return false;
    for (std::size_t i = 0; i < square_corners.size(); ++i) {
        if (!(std::abs(corners[i].*end - plane.fit.at(square_corners[i])) <= change)) return false;
    }
    return true;
}

}  // namespace

Signs signs_of(SquareStretches stretches) {
    std::array<double, square_ray_count> near{};
    std::array<double, square_ray_count> far{};
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        if (stretches[i].inner) return Signs::Unknown;
        near[i] = stretches[i].near;
        far[i] = stretches[i].far;
    }
    const int product = sign_over_square(near) * sign_over_square(far);
    return product == 0 ? Signs::Unknown : product > 0 ? Signs::Kept : Signs::Changed;
}

std::size_t EdgeSamples::roots() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(height, [](double at) { return at <= 0.0; }));
}

std::size_t EdgeSamples::deepest() const {
    return static_cast<std::size_t>(std::ranges::min_element(height) - height.begin());
}

std::size_t EdgeSamples::nearest_hit(const SquareRay& place) const {
    std::size_t nearest = deepest();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        const double x = square_rays[i].x - place.x;
        const double y = square_rays[i].y - place.y;
        const double apart = x * x + y * y;
        if (!(height[i] <= 0.0) || !(apart < least)) continue;
        nearest = i;
        least = apart;
    }
    return nearest;
}

RayRoot EdgeSamples::bracket(SquareStretches stretches, std::size_t i) const {
    const RayStretch& ray = stretches[i];
    return {.col = ray.col,
            .row = ray.row,
            .from = ray.from,
            .to = before_end[i] ? ray.to : ray.at,
            .several = true};
}

SquareRayFlags EdgeSamples::misses() const {
    SquareRayFlags none{};
    for (std::size_t i = 0; i < square_ray_count; ++i)
        none[i] = !(height[i] <= 0.0);
    return none;
}

EdgeSamples edge_samples(SquareStretches stretches) {
    const auto positive = [](double f) { return f >= 0.0; };
    const bool near = positive(stretches[0].near);
    const bool far = positive(stretches[0].far);
    const bool one_near = std::ranges::all_of(
        stretches, [&](const RayStretch& ray) { return positive(ray.near) == near; });
    const bool one_far = std::ranges::all_of(
        stretches, [&](const RayStretch& ray) { return positive(ray.far) == far; });
    EdgeSamples samples;
    samples.known = true;
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        const RayStretch& ray = stretches[i];
        samples.before_end[i] = !one_near;
        samples.known = samples.known && std::isfinite(ray.near) && std::isfinite(ray.least);
        if (ray.is_empty()) {
            samples.height[i] = std::numeric_limits<double>::infinity();
            samples.known = false;
        } else if (one_near) {
            samples.height[i] = ray.least;
        } else {
            // The rays enter through a wall on which f changes its sign: where it is already that
            // of the far end, the root is cut away.
            samples.height[i] = far ? ray.near : -ray.near;
            samples.known = samples.known && one_far && !ray.inner;
        }
    }
    return samples;
}

std::optional<EdgeSamples> one_end_samples(SquareStretches stretches) {
    const double sign = stretches[0].near >= 0.0 ? 1.0 : -1.0;
    EdgeSamples near{.height = {}, .known = true, .before_end = {}};
    EdgeSamples far = near;
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        const RayStretch& ray = stretches[i];
        near.height[i] = sign * ray.near;
        far.height[i] = sign * ray.far;
        near.before_end[i] = true;
        far.before_end[i] = true;
        const bool kept = near.height[i] > 0.0 && far.height[i] > 0.0;
        if (!kept || ray.is_empty() || ray.inner) return std::nullopt;
        if (!std::isfinite(ray.near) || !std::isfinite(ray.far)) return std::nullopt;
    }
    if (sign_over_square(near.height) > 0) return far;
    return sign_over_square(far.height) > 0 ? std::optional(near) : std::nullopt;
}

bool are_ends_even(SquareStretches stretches, CornerStretches corners) {
    return is_even(stretches, corners, &RayStretch::from) &&
           is_even(stretches, corners, &RayStretch::to);
}

std::optional<EdgeSamples> wall_samples(SquareStretches stretches, const WallEnd& wall) {
    std::array<double, square_ray_count> others{};
    for (std::size_t i = 0; i < square_ray_count; ++i)
        others[i] = stretches[i].*wall.other_f;
    const int sign = sign_of_line(line_through(others));
    if (sign == 0) return std::nullopt;
    EdgeSamples samples;
    samples.known = true;
    samples.before_end.fill(true);
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        const RayStretch& ray = stretches[i];
        const double height = sign * (ray.*wall.f);
        const bool is_rooted_beyond = ray.is_empty() && height <= 0.0;
        if (ray.inner || is_rooted_beyond || !std::isfinite(height)) return std::nullopt;
        samples.height[i] = height;
    }
    return samples;
}

RayStretch stretch_at(SquareStretches stretches, const SquareRay& place) {
    RayStretch stretch = stretches.front();
    stretch.from = plane_through(stretches, &RayStretch::from).fit.at(place);
    stretch.to = plane_through(stretches, &RayStretch::to).fit.at(place);
    return stretch;
}

EdgeSamples entry_samples(SquareStretches stretches) {
    const double sign = stretches[0].near >= 0.0 ? 1.0 : -1.0;
    EdgeSamples samples;
    samples.known = true;
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        samples.height[i] = -sign * stretches[i].near;
        samples.known =
            samples.known && !stretches[i].is_empty() && std::isfinite(stretches[i].near);
    }
    return samples;
}

std::optional<LinearOnSquare> fit_edge(const EdgeSamples& samples, double error, bool flat_too) {
    if (!samples.known) return std::nullopt;
    const auto [fit, off] = line_through(samples.height);
    if (off <= error * fit.slope()) return fit;
    const double least = std::abs(fit.value) - std::abs(fit.by_x) - std::abs(fit.by_y);
    return flat_too && least > 4.0 * off ? std::optional(fit) : std::nullopt;
}

bool is_all_below(const EdgeSamples& samples) {
    if (!samples.known) return false;
    return sign_of_line(line_through(samples.height)) < 0;
}

bool is_touched(const EdgeSamples& samples, SquareStretches stretches) {
    constexpr double most = 0.2;  // above that a thread is thicker than the square, or beside it
    const auto [least, greatest] = std::ranges::minmax(samples.height);
    if (!samples.known || !(least <= most * (greatest - least))) return false;
    // Exponentials, too, are small beside what they are at other rays. But by their slopes they
    // come to 0 equally far from all rays; a thread is nearer to some.
    constexpr double equal = 1.2;
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = 0.0;
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        const double slope = std::hypot(stretches[i].by_col, stretches[i].by_row);
        nearest = std::min(nearest, std::abs(samples.height[i]) / slope);
        farthest = std::max(farthest, std::abs(samples.height[i]) / slope);
    }
    return !(farthest < equal * nearest);
}

bool is_one_slope(SquareStretches stretches) {
    constexpr double most = 0.05;  // in parts of the slope
    const RayStretch& first = stretches[0];
    const double size = std::hypot(first.by_col, first.by_row);
    return std::ranges::all_of(stretches, [&](const RayStretch& ray) {
        return std::hypot(ray.by_col - first.by_col, ray.by_row - first.by_row) <= most * size;
    });
}

bool is_touched_everywhere(const EdgeSamples& samples, SquareStretches stretches) {
    constexpr double most = 1e-9;  // of f at the ends of stretches
    if (!samples.known || samples.roots() == square_ray_count) return false;
    double size = 0.0;
    for (const RayStretch& ray : stretches)
        size = std::max({size, std::abs(ray.near), std::abs(ray.far)});
    return std::ranges::all_of(samples.height,
                               [&](double height) { return std::abs(height) <= most * size; });
}

bool is_flush(SquareStretches stretches, CornerStretches corners) {
    constexpr double most = 1e-12;  // of f at the other end
    if (std::ranges::any_of(corners, &RayStretch::is_empty)) return false;
    const auto are_zero = [&](double RayStretch::* end, double RayStretch::* other) {
        return std::ranges::all_of(stretches, [&](const RayStretch& ray) {
            return !ray.is_empty() && std::isfinite(ray.*other) &&
                   std::abs(ray.*end) <= most * std::abs(ray.*other);
        });
    };
    return are_zero(&RayStretch::near, &RayStretch::far) ||
           are_zero(&RayStretch::far, &RayStretch::near);
}

}  // namespace zeroset
