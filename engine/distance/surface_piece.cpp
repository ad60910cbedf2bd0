#include "engine/distance/surface_piece.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

// The nearest point of a box in a half space is found by the dual problem, which for one constraint
// is piecewise linear: every multiplier gives a lower bound of the distance, so that nothing rests
// on its being the best.

namespace zeroset {
namespace {

/// A bound of all rounding errors in a piece's distances, relative to the numbers they come from.
constexpr double unit = 0x1p-44;

double rounding_of(const Box& box, const glm::dvec3& point) {
    double size = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        size += std::abs(box.lo[axis]) + std::abs(box.hi[axis]) + std::abs(point[axis]);
    }
    return unit * size;
}

/// Points x of the box [-half, half] with dot(normal, x) <= limit.
struct CutBox {
    glm::dvec3 half;
    glm::dvec3 normal;
    double limit;

    /// The point of the box that is least by |x - from|^2 / 2 + multiplier * dot(normal, x).
    [[nodiscard]] glm::dvec3 point(const glm::dvec3& from, double multiplier) const {
        return glm::clamp(from - multiplier * normal, -half, half);
    }
    [[nodiscard]] double excess(const glm::dvec3& x) const { return glm::dot(normal, x) - limit; }
    /// The multiplier of the point nearest to `from`, up to rounding; nothing where the half space
    /// misses the box.
    [[nodiscard]] std::optional<double> multiplier(const glm::dvec3& from) const {
        double below = 0.0;
        double excess_below = excess(point(from, 0.0));
        if (excess_below <= 0) return 0.0;
        double above = std::numeric_limits<double>::infinity();
        double excess_above = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            if (normal[axis] == 0) continue;
            for (const double end : {-half[axis], half[axis]}) {
                const double bend = (from[axis] - end) / normal[axis];
                if (!(bend > below && bend < above)) continue;
                const double there = excess(point(from, bend));
                (there > 0 ? below : above) = bend;
                (there > 0 ? excess_below : excess_above) = there;
            }
        }
        if (above == std::numeric_limits<double>::infinity()) return std::nullopt;
        return below + (above - below) * excess_below / (excess_below - excess_above);
    }
};

}  // namespace

double distance_below(const Box& box, const glm::dvec3& point) {
    const glm::dvec3 away = glm::max(glm::max(box.lo - point, point - box.hi), glm::dvec3(0.0));
    return std::max(0.0, glm::length(away) * (1 - unit) - rounding_of(box, point));
}

SurfacePiece hull_of(std::span<const SurfacePiece> pieces) {
    SurfacePiece hull{.box = pieces.front().box};
    for (const SurfacePiece& piece : pieces) {
        hull.box.lo = glm::min(hull.box.lo, piece.box.lo);
        hull.box.hi = glm::max(hull.box.hi, piece.box.hi);
        const bool turned = glm::dot(hull.normal, piece.normal) < 0;
        hull.normal += turned ? -piece.normal : piece.normal;
    }
    const double length = glm::length(hull.normal);
    constexpr double least_length = 0.1;  // normals that cancel out tell of no direction
    if (!(length > least_length)) return {.box = hull.box};
    hull.normal /= length;
    const glm::dvec3 middle = 0.5 * (hull.box.lo + hull.box.hi);
    double lo = std::numeric_limits<double>::infinity();
    double hi = -lo;
    for (const SurfacePiece& piece : pieces) {
        // The hull's normal is `along` times the piece's, and a rest over the whole box.
        const double along = glm::dot(hull.normal, piece.normal);
        const glm::dvec3 rest = hull.normal - along * piece.normal;
        const glm::dvec3 half = 0.5 * (piece.box.hi - piece.box.lo);
        const double center = glm::dot(hull.normal, 0.5 * (piece.box.lo + piece.box.hi) - middle) +
                              along * piece.offset;
        const double reach = std::abs(along) * piece.half_width + glm::dot(glm::abs(rest), half);
        lo = std::min(lo, center - reach);
        hi = std::max(hi, center + reach);
    }
    hull.offset = 0.5 * (lo + hi);
    hull.half_width = 0.5 * (hi - lo) + rounding_of(hull.box, middle);
    return hull;
}

bool SurfacePiece::is_empty() const {
    const glm::dvec3 half = 0.5 * (box.hi - box.lo);
    const double reach = glm::dot(glm::abs(normal), half) + rounding_of(box, glm::dvec3(0.0));
    return std::abs(offset) > reach + half_width;
}

DistanceBounds SurfacePiece::distance(const glm::dvec3& point) const {
    const glm::dvec3 middle = 0.5 * (box.lo + box.hi);
    const glm::dvec3 half = 0.5 * (box.hi - box.lo);
    const glm::dvec3 from = point - middle;
    const double rounding = rounding_of(box, point);
    DistanceBounds bounds{.lo = distance_below(box, point)};
    if (has_zero) bounds.hi = glm::length(glm::abs(from) + half) * (1 + unit) + rounding;
    if (normal == glm::dvec3(0.0)) return bounds;

    // Seen from the side of the slab on which the box's nearest point lies.
    const bool turned = glm::dot(normal, glm::clamp(from, -half, half)) < offset;
    const glm::dvec3 n = turned ? -normal : normal;
    const double level = turned ? -offset : offset;
    const CutBox slab{.half = half, .normal = n, .limit = level + half_width + rounding};
    if (const auto multiplier = slab.multiplier(from)) {
        const glm::dvec3 x = slab.point(from, *multiplier);
        const double square = glm::dot(x - from, x - from) + 2 * *multiplier * slab.excess(x);
        bounds.lo = std::max(bounds.lo, std::sqrt(std::max(square, 0.0)) * (1 - unit) - rounding);
    }
    if (!crosses) return bounds;
    // A point on the slab's middle from where its both sides are in the box.
    const glm::dvec3 inner = half - (half_width + rounding);
    if (std::min({inner.x, inner.y, inner.z}) <= 0) return bounds;
    CutBox plane{.half = inner, .normal = normal, .limit = offset};
    if (plane.excess(plane.point(from, 0.0)) < 0)
        plane = {.half = inner, .normal = -normal, .limit = -offset};
    if (const auto multiplier = plane.multiplier(from)) {
        const glm::dvec3 x = plane.point(from, *multiplier);
        const double off_plane = std::abs(plane.excess(x));
        if (off_plane <= rounding) {
            bounds.hi = std::min(bounds.hi, glm::length(x - from) * (1 + unit) + half_width +
                                                off_plane + 2 * rounding);
        }
    }
    return bounds;
}

}  // namespace zeroset
