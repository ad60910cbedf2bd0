#include "engine/trace/blobs/near_balls.hpp"

#include "engine/real/unbounded.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

/// The least number of balls that are taken for a slab, if there are so many.
constexpr std::size_t balls_in_slab = 256;

glm::dvec3 vector_of(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

constexpr auto later = [](const auto& a, const auto& b) { return a.from > b.from; };

}  // namespace

void NearBalls::begin(const BlobSet& set, double reach, const TileRays& rays, const Rays& of) {
    set_ = &set;
    reach_ = reach;
    rays_ = of;
    base_ = rays.base();
    right_ = rays.axes().right;
    up_ = rays.axes().up;
    forward_ = rays.axes().forward;
    spare_ = 16 * rays.depth_error();
    const auto side = [&](const glm::dvec3& across, double tangent) {
        const glm::dvec3 normal = across - tangent * forward_;
        return Side{
            .normal = normal, .offset = tangent * rays.distance(), .length = glm::length(normal)};
    };
    sides_ = {side(right_, of.u + of.u_radius), side(-right_, of.u_radius - of.u),
              side(up_, of.v + of.v_radius), side(-up_, of.v_radius - of.v)};
    open_.clear();
    balls_.clear();
    to_ = of.from;
    open(0);
}

/// Takes a node in, if rays may meet it.
void NearBalls::open(std::uint32_t node) {
    const BlobSet::Node& box = set_->nodes()[node];
    const glm::dvec3 lo = vector_of(box.lo);
    const glm::dvec3 hi = vector_of(box.hi);
    const glm::dvec3 half = 0.5 * (hi - lo);
    const glm::dvec3 middle = 0.5 * (hi + lo) - base_;
    const double z = glm::dot(middle, forward_);
    const double z_half = glm::dot(glm::abs(forward_), half) + spare_;
    if (!(z - z_half <= rays_.to && z + z_half >= rays_.from)) return;
    for (const Side& side : sides_) {
        const double least = glm::dot(side.normal, middle) - glm::dot(glm::abs(side.normal), half);
        if (least > side.offset + spare_) return;
    }
    open_.push_back({.from = z - z_half, .node = node});
    std::ranges::push_heap(open_, later);
}

void NearBalls::take(std::uint32_t ball) {
    const glm::dvec3 at =
        glm::dvec3(set_->center(0)[ball], set_->center(1)[ball], set_->center(2)[ball]) - base_;
    const double radius = set_->radius()[ball];
    const double support = std::sqrt(reach_) * radius + spare_;
    const double z = glm::dot(at, forward_);
    if (!(z - support <= rays_.to && z + support >= rays_.from)) return;
    for (const Side& side : sides_) {
        if (glm::dot(side.normal, at) > side.offset + side.length * support + spare_) return;
    }
    balls_.push_back({.x = glm::dot(at, right_),
                      .y = glm::dot(at, up_),
                      .z = z,
                      .support = support,
                      .radius = radius,
                      .per_square = set_->per_square()[ball],
                      .strength = set_->strength()[ball]});
}

void NearBalls::take_first() {
    std::ranges::pop_heap(open_, later);
    const std::uint32_t at = open_.back().node;
    open_.pop_back();
    const BlobSet::Node& node = set_->nodes()[at];
    if (node.right != 0) {
        open(at + 1);
        open(node.right);
        return;
    }
    for (std::uint32_t ball = node.first; ball < node.last; ++ball)
        take(ball);
}

/// Where the nodes that are left begin.
double NearBalls::next_from() const { return open_.empty() ? unbounded : open_.front().from; }

bool NearBalls::next() {
    from_ = to_;
    std::erase_if(balls_, [&](const ViewBall& ball) { return ball.to() < from_; });
    if (balls_.empty()) from_ = std::max(from_, next_from());
    const std::size_t before = balls_.size();
    while (!open_.empty() &&
           (balls_.size() < before + balls_in_slab || open_.front().from <= from_))
        take_first();
    to_ = next_from();
    fresh_.assign(balls_.begin() + static_cast<std::ptrdiff_t>(before), balls_.end());
    std::ranges::sort(balls_, {}, &ViewBall::from);
    return !balls_.empty();
}

}  // namespace zeroset
