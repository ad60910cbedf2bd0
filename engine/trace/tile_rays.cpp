#include "engine/trace/tile_rays.hpp"

#include "engine/real/rounding.hpp"
#include "engine/real/scalar.hpp"
#include "engine/real/unbounded.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

/// The column and row of the middle of a tile.
constexpr double from_first = 0.5 * (tile_size - 1);

constexpr double flat = 1e-270;  // rays less steep than this stay where they are

/// Where rays of slopes d0 to d1, from `eye`, are between the planes lo and hi: distances along
/// the view axis.
DepthRange between_planes(double eye, double lo, double hi, double d0, double d1) {
    if (d0 <= 0 && d1 >= 0) {
        if (!(lo < eye && eye < hi)) {
            return {.enter_lo = -unbounded,
                    .enter_hi = unbounded,
                    .exit_lo = -unbounded,
                    .exit_hi = unbounded};
        }
        const double steepest = std::max({-d0, d1, std::numeric_limits<double>::min()});
        return {.enter_lo = -unbounded,
                .enter_hi = 0.0,
                .exit_lo = std::min(hi - eye, eye - lo) / steepest,
                .exit_hi = unbounded};
    }
    const double near = (d0 > 0 ? lo : hi) - eye;
    const double far = (d0 > 0 ? hi : lo) - eye;
    // Divisions take long. What this rounds is far below a bound of errors of depths that matter.
    const double per_d0 = 1.0 / d0;
    const double per_d1 = 1.0 / d1;
    const double near_0 = near * per_d0;
    const double near_1 = near * per_d1;
    const double far_0 = far * per_d0;
    const double far_1 = far * per_d1;
    return {.enter_lo = std::min(near_0, near_1),
            .enter_hi = std::max(near_0, near_1),
            .exit_lo = std::min(far_0, far_1),
            .exit_hi = std::max(far_0, far_1)};
}

/// The width wanted of brackets, but no finer than double tells apart: somewhat coarser only, or
/// nothing is to be certified.
double tolerance_of(const TraceFrame& frame) {
    if (frame.stop.rule == StopRule::Epsilon) return frame.stop.value;
    const Box& clip = frame.scene.clip;
    const glm::dvec3 far = glm::max(glm::abs(clip.lo), glm::abs(clip.hi));
    const double reach = std::max({far.x, far.y, far.z});
    const double wanted = std::ldexp(clip.size(), -frame.depth.wanted);
    const double possible = 16 * std::numeric_limits<double>::epsilon() * reach;
    return possible <= std::ldexp(wanted, most_missed_halvings) ? std::max(wanted, possible)
                                                                : wanted;
}

}  // namespace

DepthRange both(const DepthRange& a, const DepthRange& b) {
    return {.enter_lo = std::max(a.enter_lo, b.enter_lo),
            .enter_hi = std::max(a.enter_hi, b.enter_hi),
            .exit_lo = std::min(a.exit_lo, b.exit_lo),
            .exit_hi = std::min(a.exit_hi, b.exit_hi)};
}

TileRays::TileRays(const TraceFrame& frame, const Tile& tile, int side)
    : view_(frame.view),
      tile_(tile),
      clip_(frame.scene.clip),
      region_(frame.scene.region),
      base_(view_.look_at()),
      distance_(beam_distance(frame)),
      pixel_(view_.pixel_size(frame.image.height) * (view_.look_distance / distance_)),
      u_first_((tile.col + 0.5 - 0.5 * frame.image.width) * pixel_),
      v_first_((0.5 * frame.image.height - tile.row - 0.5) * pixel_),
      beside_(frame.whole_pixels ? 0.5 : 0.0),
      u_most_(std::max(std::abs(u(-beside_)), std::abs(u(side)))),
      v_most_(std::max(std::abs(v(-beside_)), std::abs(v(side)))),
      extent_(std::min(clip_.size(), view_.look_distance)),
      tolerance_(tolerance_of(frame)),
      float_rays_(make_rays<float>()),
      double_rays_(make_rays<double>()) {
    depth_error_ = place_error(frame);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at((corner & 1) != 0 ? clip_.hi.x : clip_.lo.x,
                            (corner & 2) != 0 ? clip_.hi.y : clip_.lo.y,
                            (corner & 4) != 0 ? clip_.hi.z : clip_.lo.z);
        const double along = glm::dot(at - view_.eye, view_.forward);
        nearest_ = std::min(nearest_, along - depth_error_);
        farthest_ = std::max(farthest_, along + depth_error_);
    }
}

/// A power of two, so that nothing is rounded on the way from U to u and back; within float's range
/// together with what it is multiplied by.
double TileRays::beam_distance(const TraceFrame& frame) const {
    constexpr int farther = 56;
    constexpr int highest = 120;
    if (!view_.parallel()) return view_.look_distance;
    const double reach = 0x1p47 * place_error(frame);
    return std::ldexp(1.0, std::min(std::ilogb(reach) + 1 + farther, highest));
}

double TileRays::limit(std::size_t pixel) const {
    if (tile_.limits == nullptr) return unbounded;
    const double across = std::hypot(u(static_cast<double>(pixel % tile_size)),
                                     v(static_cast<double>(pixel / tile_size)));
    const double spare = 0x1p-20 * (view_.look_distance + clip_.size());
    return static_cast<double>(tile_.limits[pixel]) / std::hypot(1.0, across) -
           view_.look_distance + spare;
}

double TileRays::limit() const {
    if (tile_.limits == nullptr) return unbounded;
    double farthest = -unbounded;
    for (int row = 0; row < tile_.rows; ++row) {
        for (int col = 0; col < tile_.cols; ++col)
            farthest = std::max(farthest, limit(static_cast<std::size_t>(row * tile_size + col)));
    }
    return farthest;
}

float TileRays::distance_before(double s, double u, double v) const {
    const double distance = distance_at(s, u, v);
    const double before = distance - 0x1p-20 * std::abs(distance);
    return -float_above(-std::max(before, view_.parallel() ? -unbounded : 0.0));
}

auto TileRays::height(const glm::dvec3& normal, double offset, double error, const Rays& rays) const
    -> Height {
    const double right = glm::dot(normal, view_.right);
    const double up = glm::dot(normal, view_.up);
    const double across = right * rays.u + up * rays.v;
    const double aside = std::abs(right) * rays.u_radius + std::abs(up) * rays.v_radius;
    const double forward = glm::dot(normal, view_.forward);
    if (view_.parallel()) {
        return {.a = glm::dot(normal, base_) - offset + distance_ * across,
                .a_radius = distance_ * aside + error,
                .b = forward,
                .b_radius = 0.0};
    }
    return {.a = glm::dot(normal, view_.eye) - offset,
            .a_radius = error,
            .b = forward + across,
            .b_radius = aside + 0x1p-48};
}

DepthRange TileRays::below(const Height& height) const {
    const double shift = view_.parallel() ? 0.0 : view_.look_distance;
    const double a0 = height.a - height.a_radius;
    const double a1 = height.a + height.a_radius;
    const double b0 = height.b - height.b_radius;
    const double b1 = height.b + height.b_radius;
    DepthRange range{
        .enter_lo = -unbounded, .enter_hi = unbounded, .exit_lo = -unbounded, .exit_hi = unbounded};
    if (b0 >= 0) {
        const auto [lo, hi] = std::minmax({-a0 / std::max(b0, flat), -a0 / std::max(b1, flat),
                                           -a1 / std::max(b0, flat), -a1 / std::max(b1, flat)});
        range = {.enter_lo = -unbounded, .enter_hi = -unbounded, .exit_lo = lo, .exit_hi = hi};
    } else if (b1 <= 0) {
        const auto [lo, hi] = std::minmax({-a0 / std::min(b0, -flat), -a0 / std::min(b1, -flat),
                                           -a1 / std::min(b0, -flat), -a1 / std::min(b1, -flat)});
        range = {.enter_lo = lo, .enter_hi = hi, .exit_lo = unbounded, .exit_hi = unbounded};
    } else if (a1 < 0) {
        // Below it at the eye, where the rays begin.
        range = {
            .enter_lo = -unbounded, .enter_hi = 0.0, .exit_lo = -a1 / b1, .exit_hi = unbounded};
    } else if (a0 > 0) {
        range.enter_lo = a0 / -b0;
    }
    return {.enter_lo = range.enter_lo - shift - depth_error_,
            .enter_hi = range.enter_hi - shift + depth_error_,
            .exit_lo = range.exit_lo - shift - depth_error_,
            .exit_hi = range.exit_hi - shift + depth_error_};
}

/// By the middle of the rays: the others are no farther from it, at the same depth, than `aside`.
DepthRange TileRays::in_ball(const Ball& ball, const Rays& rays) const {
    const glm::dvec3 across = rays.u * view_.right + rays.v * view_.up;
    const double width = std::hypot(rays.u_radius, rays.v_radius);
    const double reach = view_.parallel() ? distance_ : std::max(farthest_, 0.0);
    const double aside = width * reach * (1.0 + 0x1p-20) + error_of(ball);
    const glm::dvec3 from = base_ + distance_ * across - ball.centre;
    const glm::dvec3 along = view_.forward + across;
    const double square = glm::dot(along, along);
    const double nearest = -glm::dot(from, along) / square;
    const double gap = glm::length(from + nearest * along);
    const auto half = [&](double radius) {
        return std::sqrt(std::max(radius - gap, 0.0) * (radius + gap) / square);
    };
    const double outer = ball.radius + aside;
    if (gap > outer) {
        return {.enter_lo = unbounded,
                .enter_hi = unbounded,
                .exit_lo = -unbounded,
                .exit_hi = -unbounded};
    }
    const double inner = ball.radius - aside;
    const bool sure = inner > gap;
    const double at_most = half(outer) + error_of(ball);
    const double at_least = sure ? half(inner) - error_of(ball) : 0.0;
    return {.enter_lo = nearest - at_most,
            .enter_hi = sure ? nearest - at_least : unbounded,
            .exit_lo = sure ? nearest + at_least : -unbounded,
            .exit_hi = nearest + at_most};
}

DepthRange TileRays::in_box(const Rays& rays) const {
    const double from_eye = view_.look_distance;
    if (view_.parallel()) {
        DepthRange all{.enter_lo = nearest_ - from_eye,
                       .enter_hi = -unbounded,
                       .exit_lo = unbounded,
                       .exit_hi = farthest_ - from_eye};
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 axis(0.0);
            axis[i] = 1.0;
            all = both(all, below(height(axis, clip_.hi[i], depth_error_, rays)));
            all = both(all, below(height(-axis, -clip_.lo[i], depth_error_, rays)));
        }
        return all;
    }
    DepthRange all{.enter_lo = std::max(0.0, nearest_),
                   .enter_hi = 0.0,
                   .exit_lo = unbounded,
                   .exit_hi = farthest_};
    for (int i = 0; i < 3; ++i) {
        const double d = view_.forward[i] + rays.u * view_.right[i] + rays.v * view_.up[i];
        const double across = std::abs(view_.right[i]) * rays.u_radius +
                              std::abs(view_.up[i]) * rays.v_radius + 0x1p-48;
        all = both(all,
                   between_planes(view_.eye[i], clip_.lo[i], clip_.hi[i], d - across, d + across));
    }
    return {.enter_lo = all.enter_lo - from_eye - depth_error_,
            .enter_hi = all.enter_hi - from_eye + depth_error_,
            .exit_lo = all.exit_lo - from_eye - depth_error_,
            .exit_hi = all.exit_hi - from_eye + depth_error_};
}

auto TileRays::stretch_inside(double u, double v) const -> Stretch {
    if (view_.parallel() || !region_.is_whole()) {
        const DepthRange range = depths(u, v, 0.0, 0.0);
        return {.from = 0.5 * range.enter_lo + 0.5 * range.enter_hi,
                .to = 0.5 * range.exit_lo + 0.5 * range.exit_hi};
    }
    Stretch inside{.from = std::max(0.0, nearest_), .to = farthest_};
    for (int i = 0; i < 3; ++i) {
        const double d = view_.forward[i] + u * view_.right[i] + v * view_.up[i];
        const double per_depth = 1.0 / (std::abs(d) > flat ? d : std::copysign(flat, d));
        const double lo = (clip_.lo[i] - view_.eye[i]) * per_depth;
        const double hi = (clip_.hi[i] - view_.eye[i]) * per_depth;
        inside.from = std::max(inside.from, std::min(lo, hi));
        inside.to = std::min(inside.to, std::max(lo, hi));
    }
    return {.from = inside.from - view_.look_distance, .to = inside.to - view_.look_distance};
}

DepthRange TileRays::depths_kept(const Section& section, double u, double v, double u_radius,
                                 double v_radius) const {
    return below(height(section.normal, section.offset, error_of(section),
                        {.u = u, .v = v, .u_radius = u_radius, .v_radius = v_radius}));
}

DepthRange TileRays::depths_uncut(double u, double v, double u_radius, double v_radius) const {
    const Rays rays{.u = u, .v = v, .u_radius = u_radius, .v_radius = v_radius};
    const DepthRange all = in_box(rays);
    return region_.ball ? both(all, in_ball(*region_.ball, rays)) : all;
}

DepthRange TileRays::depths(double u, double v, double u_radius, double v_radius) const {
    DepthRange all = depths_uncut(u, v, u_radius, v_radius);
    for (const Section& section : region_.sections)
        all = both(all, depths_kept(section, u, v, u_radius, v_radius));
    return all;
}

template <class Real>
FrustumOf<Real> TileRays::frustum(int pixels) const {
    constexpr double unit = std::numeric_limits<Real>::epsilon();
    const auto number = [](double value) { return static_cast<Real>(value); };
    FrustumOf<Real> frustum{};
    const double radius = radius_of(pixels) * pixel_;
    // The middle of a cell is off by half a unit of |u|.
    frustum.u_radius = upper_end(Real{}, pixels == 1 ? 0.0 : radius + unit * u_most_);
    frustum.v_radius = upper_end(Real{}, pixels == 1 ? 0.0 : radius + unit * v_most_);
    frustum.distance = number(distance_);
    for (int i = 0; i < 3; ++i) {
        frustum.base[i] = number(base_[i]);
        frustum.right[i] = number(view_.right[i]);
        frustum.up[i] = number(view_.up[i]);
        frustum.forward[i] = number(view_.forward[i]);
        const double across = std::abs(view_.right[i]) * u_most_ + std::abs(view_.up[i]) * v_most_;
        const double direction = std::abs(view_.forward[i]) + across;
        // The error of making `base` in double, in units of this format.
        const double base_error = 0x1p-50 / unit * (std::abs(view_.eye[i]) + view_.look_distance);
        const double size = std::abs(base_[i]) + distance_ * across;
        frustum.size[i] = upper_end(Real{}, (size + base_error) * (1.0 + 0x1p-20));
        frustum.direction_size[i] = upper_end(Real{}, direction * (1.0 + 0x1p-20));
    }
    return frustum;
}

/// In a wider type first, so that each number is rounded once.
template <class Real>
RaysOf<Real> TileRays::make_rays() const {
    using Wide = long double;
    const NearestRounding nearest;
    const Wide pixel = pixel_;
    const Wide u = u_first_ + from_first * pixel;
    const Wide v = v_first_ - from_first * pixel;
    RaysOf<Real> rays{};
    for (int i = 0; i < 3; ++i) {
        const Wide right = view_.right[i];
        const Wide up = view_.up[i];
        const Wide across = u * right + v * up;
        const Wide distance = distance_;
        rays.origin[i] = static_cast<Real>(Wide{base_[i]} + distance * across);
        rays.origin_by_col[i] = static_cast<Real>(distance * pixel * right);
        rays.origin_by_row[i] = static_cast<Real>(-distance * pixel * up);
        rays.direction[i] = static_cast<Real>(Wide{view_.forward[i]} + across);
        rays.direction_by_col[i] = static_cast<Real>(pixel * right);
        rays.direction_by_row[i] = static_cast<Real>(-pixel * up);
    }
    return rays;
}

template FrustumOf<float> TileRays::frustum(int pixels) const;
template FrustumOf<double> TileRays::frustum(int pixels) const;

}  // namespace zeroset
