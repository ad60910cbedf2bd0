#pragma once

#include "engine/trace/tile.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cmath>
#include <limits>

namespace zeroset {

/// Where the rays of a tile, or of one pixel, are inside something convex, as depths s: they enter
/// between enter_lo and enter_hi, and leave between exit_lo and exit_hi.
struct DepthRange {
    double enter_lo, enter_hi, exit_lo, exit_hi;

    /// Whether no ray is inside at any depth.
    [[nodiscard]] bool empty() const { return !(enter_lo <= exit_hi); }
};

/// Where rays are inside both.
DepthRange both(const DepthRange& a, const DepthRange& b);

/// A column or row of a tile as RaysOf counts it.
constexpr float from_middle(float pixels) {
    return pixels - 0.5F * static_cast<float>(tile_size - 1);
}
constexpr float from_middle(int pixels) { return from_middle(static_cast<float>(pixels)); }

/// The rays of a tile as beams see them: the point at depth s on the ray of a pixel at (u, v) of
/// the image plane is
///   base + (distance + s) (u right + v up) + s forward
/// with s measured along the view axis from the plane through the point looked at, where floats
/// are finest.
///
/// Parallel rays are those of an eye very far away: `distance` is then a power of two D, some 2^56
/// times the largest of the scene's sizes, and u = U / D for a ray at U from the axis. What is
/// proved of beams holds for any distance; only the rays are not quite those of the view: at depth
/// s they are off by s U / D, less than 2^-55 of s and of U (TileHits allows 2^-48).
class TileRays {
public:
    /// `side`: of the tile, at most, in pixels.
    TileRays(const TraceFrame& frame, const Tile& tile, int side = tile_size);

    /// u and v of a pixel's centre; columns and rows count from the tile's first pixel.
    [[nodiscard]] double u(double col) const { return u_first_ + col * pixel_; }
    [[nodiscard]] double v(double row) const { return v_first_ - row * pixel_; }
    [[nodiscard]] double pixel() const { return pixel_; }
    /// The middle of some pixels in a row, from the first one's centre; and the radius of their
    /// rays: of those through their centres, or of all of them (TraceFrame::whole_pixels).
    static constexpr double middle_of(int pixels) { return 0.5 * (pixels - 1); }
    [[nodiscard]] double radius_of(int pixels) const { return middle_of(pixels) + beside_; }
    [[nodiscard]] double distance() const { return distance_; }
    /// The distance from the eye, or from the plane through it, to the plane s = 0.
    [[nodiscard]] double look_distance() const { return view_.look_distance; }
    [[nodiscard]] const glm::dvec3& base() const { return base_; }
    [[nodiscard]] const ViewFrame& axes() const { return view_; }
    [[nodiscard]] const Box& clip() const { return clip_; }
    [[nodiscard]] const Region& region() const { return region_; }
    /// Depths from where on something is seen, but for depth_error: the eye's in perspective.
    [[nodiscard]] double first_depth() const {
        return view_.parallel() ? -std::numeric_limits<double>::infinity() : -view_.look_distance;
    }

    /// The point at depth s on the ray of a pixel of the tile.
    [[nodiscard]] glm::dvec3 point(double col, double row, double s) const {
        const glm::dvec3 across = u(col) * view_.right + v(row) * view_.up;
        return base_ + distance() * across + s * (view_.forward + across);
    }
    /// Where all rays within the radii of (u, v) are inside the clip box and the region, and in
    /// front of the eye.
    [[nodiscard]] DepthRange depths(double u, double v, double u_radius, double v_radius) const;
    /// Where the ray of (u, v) is inside, to rounding errors; empty where `from` > `to`.
    struct Stretch {
        double from, to;
    };
    [[nodiscard]] Stretch stretch_inside(double u, double v) const;
    /// `depths` as if there were no sections.
    [[nodiscard]] DepthRange depths_uncut(double u, double v, double u_radius,
                                          double v_radius) const;
    /// Where those rays are on the side that the section keeps. Of one ray it holds to rounding
    /// errors.
    [[nodiscard]] DepthRange depths_kept(const Section& section, double u, double v,
                                         double u_radius, double v_radius) const;
    /// The distance, as Framebuffer has them, of depth s on the ray of (u, v).
    [[nodiscard]] double distance_at(double s, double u, double v) const {
        return (view_.look_distance + s) * std::sqrt(1.0 + u * u + v * v);
    }
    /// A distance surely no farther than depth s on the ray of (u, v).
    [[nodiscard]] float distance_before(double s, double u, double v) const;

    /// The frustum of cells of `pixels` x `pixels` pixels; of one pixel its ray alone.
    template <class Real>
    [[nodiscard]] FrustumOf<Real> frustum(int pixels) const;

    /// The rays of the tile's pixels as kernels take them: a RaysOf<Real>.
    template <class Real>
    [[nodiscard]] const Real* kernel_rays() const {
        if constexpr (std::is_same_v<Real, float>) {
            return float_rays_.origin;
        } else {
            return double_rays_.origin;
        }
    }

    [[nodiscard]] const RaysOf<double>& double_rays() const { return double_rays_; }

    /// The depth behind which nothing is wanted on the ray of a pixel of the tile (Tile::limits),
    /// or a little more; +inf: all is wanted.
    [[nodiscard]] double limit(std::size_t pixel) const;
    /// The depth behind which nothing is wanted on any ray of the tile.
    [[nodiscard]] double limit() const;

    /// The size of what is seen: the clip box's longest edge, or less in a deep view.
    [[nodiscard]] double extent() const { return extent_; }
    /// A step of Newton's method after which the next one is below what float tells apart.
    [[nodiscard]] double small_step() const { return 0x1p-11 * extent_; }
    /// A bound of the rounding errors of a few operations in double on depths.
    [[nodiscard]] double depth_error() const { return depth_error_; }
    /// A bound of the rounding errors of distances from a section plane, or a ball's surface.
    template <class Shape>
    [[nodiscard]] double error_of(const Shape& shape) const {
        return depth_error_ + 0x1p-46 * size_of(shape);
    }
    /// The width of a bracket that is narrow enough.
    [[nodiscard]] double tolerance() const { return tolerance_; }

private:
    template <class Real>
    [[nodiscard]] RaysOf<Real> make_rays() const;
    /// A plane seen by the rays within the radii of (u, v): dot(n, p) - offset at t is a + t b,
    /// with t from the eye in perspective, where a is known to `error`, else from the plane s = 0,
    /// where b is.
    struct Height {
        double a, a_radius, b, b_radius;
    };
    struct Rays {
        double u, v, u_radius, v_radius;
    };
    [[nodiscard]] Height height(const glm::dvec3& normal, double offset, double error,
                                const Rays& rays) const;
    /// Where the height is at most 0.
    [[nodiscard]] DepthRange below(const Height& height) const;
    [[nodiscard]] DepthRange in_ball(const Ball& ball, const Rays& rays) const;
    [[nodiscard]] DepthRange in_box(const Rays& rays) const;
    [[nodiscard]] double beam_distance(const TraceFrame& frame) const;

    const ViewFrame& view_;
    const Tile& tile_;
    const Box& clip_;
    const Region& region_;
    glm::dvec3 base_;
    double distance_;
    double pixel_, u_first_, v_first_;
    double beside_;           ///< how far rays may be from the centres of their pixels, in pixels
    double u_most_, v_most_;  ///< of |u| and |v| in the tile
    double extent_, depth_error_, tolerance_;
    /// Distances of the clip box from the eye along the view axis.
    double nearest_ = std::numeric_limits<double>::infinity();
    double farthest_ = -std::numeric_limits<double>::infinity();
    RaysOf<float> float_rays_;
    RaysOf<double> double_rays_;
};

}  // namespace zeroset
