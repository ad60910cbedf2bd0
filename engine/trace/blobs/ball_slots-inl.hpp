// The balls that rays of a vector meet, and how well they are known (ray_march-inl.hpp).
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BALL_SLOTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BALL_SLOTS_INL
#undef ZEROSET_BALL_SLOTS_INL
#else
#define ZEROSET_BALL_SLOTS_INL
#endif

#include "engine/real/lanes-inl.hpp"
#include "engine/trace/blobs/ray_block.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A ball that some rays meet, in their lanes.
template <class Real>
struct SlotOf {
    using Lanes = Real[lanes<Real>];

    alignas(64) Lanes nearest;  ///< the depth where a ray is nearest to the middle
    Lanes q;                    ///< there
    Lanes enter, leave;         ///< where it may reach the ray; never: +inf, -inf
    Lanes x, y;                 ///< the middle, from where the ray is at its depth
    Real z, per_square, strength, weight, size, spare;
    Real last;  ///< the largest of `leave`
    double error, slope_error;
};

/// Numbers of some rays of a block, a ray a lane; 0 in lanes without one.
template <class Real>
HWY_INLINE V<Real> column_of(const BallBlock::Numbers& numbers,
                             std::span<const std::uint8_t> places) {
    alignas(64) Real lane[lanes<Real>];
    for (std::size_t i = 0; i < lanes<Real>; ++i)
        lane[i] = static_cast<Real>(i < places.size() ? numbers[places[i]] : 0.0);
    return hn::Load(d<Real>, lane);
}

/// Where rays of a block go (BallBlock), and the squares of their directions.
template <class Real>
struct VectorOfRays {
    V<Real> u, v, start_x, start_y, tilt_x, tilt_y;
    V<Real> square, per_square;

    HWY_INLINE VectorOfRays(const BallBlock& block, std::span<const std::uint8_t> places)
        : u(column_of<Real>(block.u, places)),
          v(column_of<Real>(block.v, places)),
          start_x(column_of<Real>(block.start_x, places)),
          start_y(column_of<Real>(block.start_y, places)),
          tilt_x(column_of<Real>(block.tilt_x, places)),
          tilt_y(column_of<Real>(block.tilt_y, places)) {
        const V<Real> one = hn::Set(d<Real>, Real{1});
        square = hn::MulAdd(u, u, hn::MulAdd(v, v, one));
        per_square = hn::Div(one, square);
    }
};

/// Error bounds that all balls of a block share.
template <class Real>
struct MarchBounds {
    double place_error;  ///< of balls from rays, but for their own size
    double per_reach;    ///< what adds to it for each unit of a ball's support
    double rounding;     ///< of a ball's height, by its strength
    double base;         ///< of f, from no ball
    double length;       ///< of the directions, at most
    double spare = 0;    ///< how much farther than they reach balls are looked at

    /// How far a ball may be from where rays find it.
    [[nodiscard]] double off(const ViewBall& ball) const {
        return place_error + per_reach * ball.support;
    }

    explicit MarchBounds(const BallQuestion& question) {
        constexpr double unit = std::numeric_limits<Real>::epsilon();
        const double square = question.square;
        length = std::sqrt(square);
        // Some four roundings of depths and ten of places across, each of a unit; twice.
        place_error =
            question.place_error + 8 * unit * (question.extent + 2 * length * question.width);
        per_reach = 32 * unit * square;
        rounding = unit * (64 * (square + 1) + 2 * static_cast<double>(question.balls.size()));
        for (const ViewBall& ball : question.balls)
            spare = std::max(spare, ball.support * 0x1p-10 + 4 * off(ball));
        base = question.tail + 64 * unit * std::abs(question.level);
    }
};

/// A bound of the error of a second derivative where the ball is off by this share of its radius at
/// most.
template <BlobKind kind, class Real>
constexpr double curve_spare(double by_radius) {
    constexpr double unit = std::numeric_limits<Real>::epsilon();
    // q is off by 2 sqrt(q) by_radius at most. By that Wyvill's change by less than 25 of it,
    // Blinn's by 250; metaballs' jump by 6 where q is 4/9, which is looked for 0.004 beside that.
    constexpr double steepest = kind == BlobKind::Wyvill ? 64 : 2048;
    return steepest * (by_radius + 8 * unit);
}

/// Sets what a slot has of its ball alone.
template <BlobKind kind, class Real>
void set_ball(SlotOf<Real>& slot, const ViewBall& ball, const MarchBounds<Real>& bounds) {
    const auto set = [](Real& to, double x) { to = static_cast<Real>(x); };
    constexpr BlobFacts facts = blob_facts(kind);
    const double size = std::abs(ball.strength);
    set(slot.z, ball.z);
    set(slot.per_square, ball.per_square);
    set(slot.strength, ball.strength);
    set(slot.weight, 2 * ball.strength * ball.per_square);
    const double by_radius = bounds.off(ball) / ball.radius;
    set(slot.size, size * ball.per_square);
    set(slot.spare, curve_spare<kind, Real>(by_radius));
    slot.error = size * (facts.slope * by_radius + facts.top * bounds.rounding);
    slot.slope_error = bounds.length * size / ball.radius *
                       (facts.bend * by_radius + facts.slope * bounds.rounding);
    if (by_radius > 0.01) slot.error = std::numeric_limits<double>::infinity();
}

/// The distance on which f cannot come to 0 from `clearance` away, while it nears 0 by `rise`,
/// which grows by `curve` at most.
template <class Real>
HWY_INLINE V<Real> safe_step(V<Real> clearance, V<Real> rise, V<Real> curve) {
    const V<Real> twice = hn::Add(clearance, clearance);
    const V<Real> square = hn::MulAdd(rise, rise, hn::Mul(twice, curve));
    const V<Real> root = hn::Sqrt(hn::Max(square, hn::Zero(d<Real>)));
    const M<Real> rises = hn::Ge(rise, hn::Zero(d<Real>));
    const V<Real> above = hn::IfThenElse(rises, twice, hn::Sub(root, rise));
    const V<Real> below = hn::IfThenElse(rises, hn::Add(rise, root), curve);
    const V<Real> step = hn::Mul(hn::Div(above, below), number<Real>(1 - 0x1p-10));
    const M<Real> comes =
        hn::And(hn::Gt(below, hn::Zero(d<Real>)), hn::Ge(square, hn::Zero(d<Real>)));
    return hn::IfThenElse(comes, step, number<Real>(1e30));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
