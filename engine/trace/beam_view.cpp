#include "engine/trace/beam_view.hpp"

#include "engine/num/rounding.hpp"
#include "engine/num/scalar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

/// Of the middle of a tile, in pixels.
constexpr double from_first = 0.5 * (tile_size - 1);

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Where rays of slopes d0 to d1, from `eye`, are between the planes lo and hi: distances along
/// the view axis.
DepthRange between_planes(double eye, double lo, double hi, double d0, double d1) {
    if (d0 <= 0 && d1 >= 0) {
        if (!(lo < eye && eye < hi)) return {-unbounded, unbounded, -unbounded, unbounded};
        const double steepest = std::max({-d0, d1, std::numeric_limits<double>::min()});
        return {-unbounded, 0.0, std::min(hi - eye, eye - lo) / steepest, unbounded};
    }
    const double near = (d0 > 0 ? lo : hi) - eye;
    const double far = (d0 > 0 ? hi : lo) - eye;
    const auto [enter_lo, enter_hi] = std::minmax({near / d0, near / d1});
    const auto [exit_lo, exit_hi] = std::minmax({far / d0, far / d1});
    return {enter_lo, enter_hi, exit_lo, exit_hi};
}

/// As wide as wanted, but no finer than double tells apart: somewhat coarser only, or nothing is to
/// be certified.
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

BeamView::BeamView(const TraceFrame& frame, const Tile& tile, int side)
    : view_(frame.view),
      tile_(tile),
      clip_(frame.scene.clip),
      base_(view_.eye + view_.look_distance * view_.forward),
      pixel_(view_.pixel_size(frame.height)),
      u_first_((tile.col + 0.5 - 0.5 * frame.width) * pixel_),
      v_first_((0.5 * frame.height - tile.row - 0.5) * pixel_),
      u_most_(std::max(std::abs(u_first_), std::abs(u(side)))),
      v_most_(std::max(std::abs(v_first_), std::abs(v(side)))),
      extent_(std::min(clip_.size(), view_.look_distance)),
      tolerance_(tolerance_of(frame)),
      float_rays_(make_rays<float>()),
      double_rays_(make_rays<double>()) {
    const glm::dvec3 eye = glm::abs(view_.eye);
    const glm::dvec3 box = glm::max(glm::abs(clip_.lo), glm::abs(clip_.hi));
    const double largest = std::max({eye.x, eye.y, eye.z}) + std::max({box.x, box.y, box.z});
    depth_error_ = 0x1p-46 * (largest + view_.look_distance);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at((corner & 1) != 0 ? clip_.hi.x : clip_.lo.x,
                            (corner & 2) != 0 ? clip_.hi.y : clip_.lo.y,
                            (corner & 4) != 0 ? clip_.hi.z : clip_.lo.z);
        const double along = glm::dot(at - view_.eye, view_.forward);
        nearest_ = std::min(nearest_, along - depth_error_);
        farthest_ = std::max(farthest_, along + depth_error_);
    }
}

double BeamView::limit(std::size_t pixel) const {
    if (tile_.limits == nullptr) return unbounded;
    const double across = std::hypot(u(static_cast<double>(pixel % tile_size)),
                                     v(static_cast<double>(pixel / tile_size)));
    const double spare = 0x1p-20 * (view_.look_distance + clip_.size());
    return static_cast<double>(tile_.limits[pixel]) / std::hypot(1.0, across) -
           view_.look_distance + spare;
}

double BeamView::limit() const {
    if (tile_.limits == nullptr) return unbounded;
    double farthest = -unbounded;
    for (int row = 0; row < tile_.rows; ++row) {
        for (int col = 0; col < tile_.cols; ++col)
            farthest = std::max(farthest, limit(static_cast<std::size_t>(row * tile_size + col)));
    }
    return farthest;
}

DepthRange BeamView::depths(double u, double v, double u_radius, double v_radius) const {
    DepthRange all{std::max(0.0, nearest_), 0.0, unbounded, farthest_};
    for (int i = 0; i < 3; ++i) {
        const double d = view_.forward[i] + u * view_.right[i] + v * view_.up[i];
        const double across =
            std::abs(view_.right[i]) * u_radius + std::abs(view_.up[i]) * v_radius + 0x1p-48;
        const DepthRange one =
            between_planes(view_.eye[i], clip_.lo[i], clip_.hi[i], d - across, d + across);
        all = {std::max(all.enter_lo, one.enter_lo), std::max(all.enter_hi, one.enter_hi),
               std::min(all.exit_lo, one.exit_lo), std::min(all.exit_hi, one.exit_hi)};
    }
    const double from_eye = view_.look_distance;
    return {all.enter_lo - from_eye - depth_error_, all.enter_hi - from_eye + depth_error_,
            all.exit_lo - from_eye - depth_error_, all.exit_hi - from_eye + depth_error_};
}

template <class Real>
FrustumOf<Real> BeamView::frustum(int pixels) const {
    constexpr double unit = std::numeric_limits<Real>::epsilon();
    const auto number = [](double value) { return static_cast<Real>(value); };
    FrustumOf<Real> frustum{};
    const double radius = 0.5 * (pixels - 1) * pixel_;
    // The middle of a cell is off by half a unit of |u|.
    frustum.u_radius = upper_end(Real{}, pixels == 1 ? 0.0 : radius + unit * u_most_);
    frustum.v_radius = upper_end(Real{}, pixels == 1 ? 0.0 : radius + unit * v_most_);
    frustum.distance = number(view_.look_distance);
    for (int i = 0; i < 3; ++i) {
        frustum.base[i] = number(base_[i]);
        frustum.right[i] = number(view_.right[i]);
        frustum.up[i] = number(view_.up[i]);
        frustum.forward[i] = number(view_.forward[i]);
        const double across = std::abs(view_.right[i]) * u_most_ + std::abs(view_.up[i]) * v_most_;
        const double direction = std::abs(view_.forward[i]) + across;
        // What making `base` in double has cost, in units of this format.
        const double base_error = 0x1p-50 / unit * (std::abs(view_.eye[i]) + view_.look_distance);
        const double size = std::abs(base_[i]) + view_.look_distance * across;
        frustum.size[i] = upper_end(Real{}, (size + base_error) * (1.0 + 0x1p-20));
        frustum.direction_size[i] = upper_end(Real{}, direction * (1.0 + 0x1p-20));
    }
    return frustum;
}

/// In a wider type first, so that each number is rounded once.
template <class Real>
RaysOf<Real> BeamView::make_rays() const {
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
        const Wide distance = view_.look_distance;
        rays.origin[i] = static_cast<Real>(Wide{base_[i]} + distance * across);
        rays.origin_by_col[i] = static_cast<Real>(distance * pixel * right);
        rays.origin_by_row[i] = static_cast<Real>(-distance * pixel * up);
        rays.direction[i] = static_cast<Real>(Wide{view_.forward[i]} + across);
        rays.direction_by_col[i] = static_cast<Real>(pixel * right);
        rays.direction_by_row[i] = static_cast<Real>(-pixel * up);
    }
    return rays;
}

template FrustumOf<float> BeamView::frustum(int pixels) const;
template FrustumOf<double> BeamView::frustum(int pixels) const;

}  // namespace zeroset
