// Rays, one a lane, on their way through soft balls.
//   s      the depth along the view; f is known to be on one side of the level up to here
//   ds     from where a ray is nearest to a ball's middle
//   q      the square of the distance from a ball's middle, by the ball's radius
//   clearance   how far f is from the level, at least, along the side that it is on
//
// Along a ray q is nearest + square ds^2. f is once differentiable, and where certain balls are all
// that reach a stretch of the ray, its second derivative is bounded there by theirs. So from
// clearance, slope and that bound follows how long f cannot come to the level: a step of Newton's
// method that is always too short, of second order near a root. Where no ball reaches, the step
// goes to the next one. [Kalra89] has the idea with bounds of slopes.
//
// What is proved: balls are where they are to an error (`MarchBounds`), as are the rays; this moves
// f by no more than that times the slopes of the balls, and its slope by that times their second
// derivatives, which `error_` and `slope_error_` take from clearance and add to the slope. Rounding
// of a step is of the size of those of places, which are counted twice. Included once for each
// instruction set, after Highway.

#if defined(ZEROSET_RAY_MARCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_RAY_MARCH_INL
#undef ZEROSET_RAY_MARCH_INL
#else
#define ZEROSET_RAY_MARCH_INL
#endif

#include "engine/blobs/blob_heights-inl.hpp"
#include "engine/real/lanes-inl.hpp"
#include "engine/trace/blobs/ball_bends-inl.hpp"
#include "engine/trace/blobs/ball_slots-inl.hpp"
#include "engine/trace/blobs/ray_block.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real, BlobKind kind>
class RayMarch {
public:
    using Slot = SlotOf<Real>;

    /// The rays at some places of the block, at most as many as there are lanes.
    RayMarch(const BallQuestion& question, BallBlock& block, const MarchBounds<Real>& bounds,
             std::span<const std::uint8_t> places, std::vector<Slot>& slots)
        : question_(question), block_(block), bounds_(bounds), places_(places), slots_(slots) {
        load();
    }

    /// Rays that could not be brought to an end in so many steps are left open. Returns how often f
    /// was looked at.
    BallEvaluations run() {
        constexpr int most_steps = is_double ? 400 : 200;
        BallEvaluations evaluations = 0;
        for (int i = 0; i < most_steps && !hn::AllFalse(d<Real>, open_); ++i) {
            evaluations += hn::CountTrue(d<Real>, open_);
            advance();
        }
        store();
        return evaluations;
    }

private:
    static constexpr bool is_double = std::is_same_v<Real, double>;
    static constexpr std::size_t width = lanes<Real>;
    static constexpr Real unbounded = std::numeric_limits<Real>::infinity();

    /// f, its slope along the ray, and bounds of the slope's change, each by the direction's square
    /// but f.
    struct Sums {
        V<Real> value, slope, curve;
        M<Real> empty;  ///< no ball reaches
    };

    static HWY_INLINE V<Real> same(Real x) { return hn::Set(d<Real>, x); }
    static HWY_INLINE V<Real> zero() { return hn::Zero(d<Real>); }

    /// A number of this type at `at` or little before: what is skipped would never be looked at.
    static HWY_INLINE Real not_behind(double at) {
        const auto near = static_cast<Real>(at);
        return static_cast<double>(near) <= at ? near : std::nextafter(near, -unbounded);
    }
    HWY_INLINE void load() {
        alignas(64) Real sides[width] = {};
        alignas(64) Real begins[width] = {};
        LaneBits bits = 0;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            sides[i] = block_.side[places_[i]];
            begins[i] = not_behind(block_.at[places_[i]]);
            if (block_.state[places_[i]] == BallRayState::Open) bits |= LaneBits{1} << i;
        }
        open_ = mask_of(d<Real>, bits);
        s_ = hn::Load(d<Real>, begins);
        stop_ = column_of<Real>(block_.stop, places_);
        side_ = hn::Load(d<Real>, sides);
        window_ = hn::Max(bracket_, number<Real>(usual_));
        level_ = number<Real>(question_.level);
        passed_ = sure_ = unsure_ = mask_of(d<Real>, 0);
        keep_sides();
    }
    HWY_INLINE void keep_sides() {
        above_ = hn::Gt(side_, zero());
        below_ = hn::Lt(side_, zero());
        fresh_ = !hn::AllFalse(d<Real>, hn::And(open_, hn::Eq(side_, zero())));
    }

    /// Takes in the balls that may reach rays between where they are and `end`, and leaves those
    /// that are behind all of them.
    HWY_INLINE void gather(V<Real> end) {
        const M<Real> reaches_next = hn::Ge(end, same(next_from_));
        if (hn::AllFalse(d<Real>, hn::And(open_, reaches_next))) return;
        const V<Real> first = hn::IfThenElse(open_, s_, number<Real>(unbounded));
        const V<Real> last = hn::IfThenElse(open_, end, number<Real>(-unbounded));
        take_between(static_cast<double>(hn::GetLane(hn::MinOfLanes(d<Real>, first))),
                     static_cast<double>(hn::GetLane(hn::MaxOfLanes(d<Real>, last))));
    }
    HWY_INLINE void take_between(double first, double last) {
        for (std::size_t i = 0; i < count_;) {
            if (static_cast<double>(slots_[i].last) >= first) {
                ++i;
            } else if (i != --count_) {
                slots_[i] = slots_[count_];
            }
        }
        const auto& balls = question_.balls;
        for (; next_ < balls.size() && balls[next_].from() - bounds_.spare <= last; ++next_) {
            if (balls[next_].to() + bounds_.spare >= first) take(balls[next_]);
        }
        find_next();
        add_errors();
    }
    /// Where the next ball begins, at most.
    HWY_INLINE void find_next() {
        const bool more = next_ < question_.balls.size();
        next_from_ =
            more ? static_cast<Real>(question_.balls[next_].from() - bounds_.spare) : unbounded;
    }
    HWY_INLINE void add_errors() {
        double error = bounds_.base;
        double slope_error = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            error += slots_[i].error;
            slope_error += slots_[i].slope_error;
        }
        error_ = error;
        slope_error_ = slope_error;
    }
    /// Takes a ball in, if it may reach a ray.
    HWY_INLINE void take(const ViewBall& ball) {
        const double off = bounds_.off(ball);
        const double support = ball.support * (1 + 0x1p-10) + 4 * off;
        const V<Real> z = number<Real>(ball.z);
        const V<Real> x =
            hn::NegMulAdd(rays_.tilt_x, z, hn::Sub(number<Real>(ball.x), rays_.start_x));
        const V<Real> y =
            hn::NegMulAdd(rays_.tilt_y, z, hn::Sub(number<Real>(ball.y), rays_.start_y));
        const V<Real> along = hn::MulAdd(rays_.u, x, hn::Mul(rays_.v, y));
        const V<Real> behind = hn::Mul(along, rays_.per_square);
        const V<Real> across = hn::MulAdd(x, x, hn::NegMulAdd(along, behind, hn::Mul(y, y)));
        const V<Real> rest = hn::Sub(number<Real>(support * support), across);
        const M<Real> meets = hn::And(open_, hn::Gt(rest, zero()));
        if (hn::AllFalse(d<Real>, meets)) return;
        if (count_ == slots_.size()) slots_.resize(2 * count_ + 8);
        Slot& slot = slots_[count_++];
        const V<Real> half = hn::Sqrt(hn::Mul(hn::Max(rest, zero()), rays_.per_square));
        const V<Real> nearest = hn::Add(z, behind);
        const V<Real> leave =
            hn::IfThenElse(meets, hn::Add(nearest, half), number<Real>(-unbounded));
        const auto keep = [](const V<Real>& numbers, Real* to) { hn::Store(numbers, d<Real>, to); };
        keep(nearest, slot.nearest);
        keep(hn::Max(hn::Mul(across, number<Real>(ball.per_square)), zero()), slot.q);
        keep(hn::IfThenElse(meets, hn::Sub(nearest, half), number<Real>(unbounded)), slot.enter);
        keep(leave, slot.leave);
        keep(x, slot.x);
        keep(y, slot.y);
        slot.last = hn::GetLane(hn::MaxOfLanes(d<Real>, leave));
        set_ball<kind>(slot, ball, bounds_);
        usual_ = ball.radius / bounds_.length;
    }

    static HWY_INLINE V<Real> reach() { return number<Real>(blob_facts(kind).reach); }
    HWY_INLINE V<Real> q_at(const Slot& slot, V<Real> ds) const {
        const V<Real> q = hn::MulAdd(hn::Mul(hn::Mul(ds, rays_.square), ds), same(slot.per_square),
                                     hn::Load(d<Real>, slot.q));
        return hn::Min(q, reach());
    }
    /// A bound of how much a ball's slope towards the level changes where it reaches [s, end].
    HWY_INLINE V<Real> curve_of(const Slot& slot, V<Real> ds, V<Real> q_here, V<Real> end) const {
        const V<Real> ds_end = hn::Sub(end, hn::Load(d<Real>, slot.nearest));
        const V<Real> q_end = q_at(slot, ds_end);
        const V<Real> least = hn::Min(hn::Load(d<Real>, slot.q), reach());
        const M<Real> passes = hn::And(hn::Le(ds, zero()), hn::Ge(ds_end, zero()));
        const StretchOf<V<Real>> on{.from = hn::IfThenElse(passes, least, hn::Min(q_here, q_end)),
                                    .to = hn::Max(q_here, q_end),
                                    .least = least};
        const M<Real> rises = slot.strength < 0 ? above_ : below_;
        const M<Real> falls = slot.strength < 0 ? below_ : above_;
        V<Real> curve = number<Real>(-unbounded);
        if (!hn::AllTrue(d<Real>, falls)) curve = most_bend<kind>(d<Real>, on);
        if (!hn::AllTrue(d<Real>, rises)) {
            const V<Real> down = hn::Neg(least_bend<kind>(d<Real>, on));
            curve = hn::IfThenElse(rises, curve, hn::IfThenElse(falls, down, hn::Max(curve, down)));
        }
        return hn::Mul(hn::Add(curve, same(slot.spare)), same(slot.size));
    }
    HWY_INLINE Sums sums_at(V<Real> end) const {
        Sums sums{.value = zero(), .slope = zero(), .curve = zero(), .empty = {}};
        M<Real> some = mask_of(d<Real>, 0);
        for (std::size_t i = 0; i < count_; ++i) {
            const Slot& slot = slots_[i];
            const V<Real> ds = hn::Sub(s_, hn::Load(d<Real>, slot.nearest));
            const V<Real> q = q_at(slot, ds);
            const auto h = height_at<kind, Rounds::Once>(d<Real>, q);
            sums.value = hn::MulAdd(same(slot.strength), h.value, sums.value);
            sums.slope = hn::MulAdd(hn::Mul(ds, same(slot.weight)), h.slope, sums.slope);
            const M<Real> reaches = hn::And(hn::Le(hn::Load(d<Real>, slot.enter), end),
                                            hn::Ge(hn::Load(d<Real>, slot.leave), s_));
            sums.curve =
                hn::Add(sums.curve, hn::IfThenElseZero(reaches, curve_of(slot, ds, q, end)));
            some = hn::Or(some, reaches);
        }
        sums.slope = hn::Mul(sums.slope, rays_.square);
        sums.curve = hn::Mul(sums.curve, rays_.square);
        sums.empty = hn::Not(some);
        return sums;
    }
    /// Where the next ball after a depth may begin, at most.
    HWY_INLINE V<Real> next_entry(V<Real> after) const {
        V<Real> next = same(next_from_);
        for (std::size_t i = 0; i < count_; ++i) {
            const V<Real> enter = hn::Load(d<Real>, slots_[i].enter);
            next = hn::Min(next, hn::IfThenElse(hn::Gt(enter, after), enter, next));
        }
        return next;
    }

    HWY_INLINE void advance() {
        const V<Real> end = hn::Add(s_, window_);
        gather(end);
        const Sums sums = sums_at(end);
        // f - level
        const V<Real> f = hn::Sub(sums.value, level_);
        if (fresh_) choose_sides(f);
        const V<Real> clearance = hn::Sub(hn::Mul(side_, f), number<Real>(error_));
        const V<Real> rise = hn::Sub(number<Real>(slope_error_), hn::Mul(side_, sums.slope));
        const V<Real> step = safe_step<Real>(clearance, rise, sums.curve);
        const M<Real> empty = sums.empty;
        V<Real> next = hn::Add(s_, hn::Min(step, window_));
        const M<Real> has_clearance = hn::Gt(clearance, zero());
        if (!hn::AllFalse(d<Real>, hn::AndNot(hn::Not(open_), empty)))
            next = hn::IfThenElse(empty, hn::Max(end, next_entry(end)), next);
        const M<Real> ends = hn::And(open_, hn::And(has_clearance, hn::Ge(next, stop_)));
        passed_ = hn::Or(passed_, ends);
        open_ = hn::AndNot(ends, open_);
        const M<Real> near = hn::And(open_, hn::Or(hn::Not(has_clearance), hn::Le(step, bracket_)));
        if (tries_ && !hn::AllFalse(d<Real>, near))
            certify(near, hn::IfThenElseZero(has_clearance, step), clearance, rise);
        // In floats no more is known of what is nearer than some errors.
        const M<Real> moves =
            hn::And(hn::Gt(clearance, number<Real>(is_double ? 0 : 4 * error_)), hn::Gt(next, s_));
        const M<Real> stuck = hn::AndNot(moves, open_);
        if (!hn::AllFalse(d<Real>, stuck)) end_stuck(stuck);
        s_ = hn::IfThenElse(open_, next, s_);
        const V<Real> wider = hn::Add(window_, window_);
        const V<Real> narrower = hn::Mul(step, number<Real>(1.15));
        window_ = hn::IfThenElse(empty, number<Real>(usual_), hn::Min(wider, narrower));
        window_ = hn::Max(window_, hn::Max(bracket_, number<Real>(0x1p-7 * usual_)));
    }
    HWY_INLINE void choose_sides(V<Real> f) {
        const V<Real> error = number<Real>(error_);
        const V<Real> found =
            hn::IfThenElse(hn::Gt(f, error), number<Real>(1),
                           hn::IfThenElse(hn::Lt(f, hn::Neg(error)), number<Real>(-1), zero()));
        side_ = hn::IfThenElse(hn::Eq(side_, zero()), found, side_);
        keep_sides();
    }

    HWY_INLINE void certify(M<Real> near, V<Real> step, V<Real> clearance, V<Real> rise) {
        const V<Real> widest = hn::Mul(number<Real>(0.98), bracket_);
        certify(near, step, widest);
        const M<Real> left = hn::And(near, open_);
        if (!is_double || hn::AllFalse(d<Real>, left)) return;
        // f may come back within a bracket: looks where it is just far enough beyond the level.
        const V<Real> wanted =
            hn::MulAdd(number<Real>(4), hn::Max(clearance, zero()), number<Real>(16 * error_));
        const V<Real> wide = hn::Div(wanted, hn::Max(rise, number<Real>(1e-30)));
        certify(left, step, hn::Min(wide, widest));
    }
    /// Looks at lanes further on, by no more than a bracket: f may be sure to be on the other side
    /// there.
    HWY_INLINE void certify(M<Real> near, V<Real> step, V<Real> wide) {
        const V<Real> to = hn::Min(hn::Add(s_, wide), stop_);
        V<Real> value = zero();
        V<Real> slope[3] = {zero(), zero(), zero()};
        for (std::size_t i = 0; i < count_; ++i) {
            const Slot& slot = slots_[i];
            const V<Real> ds = hn::Sub(to, hn::Load(d<Real>, slot.nearest));
            const auto h = height_at<kind, Rounds::Once>(d<Real>, q_at(slot, ds));
            value = hn::MulAdd(same(slot.strength), h.value, value);
            const V<Real> steep = hn::Mul(same(slot.weight), h.slope);
            const V<Real> x = hn::Load(d<Real>, slot.x);
            const V<Real> y = hn::Load(d<Real>, slot.y);
            slope[0] = hn::NegMulAdd(steep, x, slope[0]);
            slope[1] = hn::NegMulAdd(steep, y, slope[1]);
            slope[2] = hn::MulAdd(steep, hn::Sub(to, same(slot.z)), slope[2]);
        }
        slope[0] = hn::MulAdd(rays_.u, slope[2], slope[0]);
        slope[1] = hn::MulAdd(rays_.v, slope[2], slope[1]);
        const V<Real> beyond = hn::Mul(side_, hn::Sub(level_, value));
        const M<Real> sure = hn::And(near, hn::Gt(beyond, number<Real>(error_)));
        sure_ = hn::Or(sure_, sure);
        open_ = hn::AndNot(sure, open_);
        const V<Real> depth = hn::Add(s_, hn::Min(step, hn::Sub(to, s_)));
        tell(sure, depth, to, slope);
        if (!is_double) return;
        last_slope_[0] = slope[0];
        last_slope_[1] = slope[1];
        last_slope_[2] = slope[2];
    }
    HWY_INLINE void tell(M<Real> which, V<Real> depth, V<Real> to, const V<Real>* slope) {
        alignas(64) Real depths[width], ends[width], slopes[3][width];
        hn::Store(depth, d<Real>, depths);
        hn::Store(to, d<Real>, ends);
        for (std::size_t k = 0; k < 3; ++k)
            hn::Store(slope[k], d<Real>, slopes[k]);
        for (LaneBits bits = bits_of(d<Real>, which); bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            const std::size_t place = places_[lane];
            block_.to[place] = ends[lane];
            block_.depth[place] = depths[lane];
            for (std::size_t k = 0; k < 3; ++k)
                block_.slope[k][place] = slopes[k][lane];
        }
    }
    /// Ends lanes that cannot go on: in floats they are left open.
    HWY_INLINE void end_stuck(M<Real> stuck) {
        if constexpr (is_double) {
            end_unsure(stuck);
        } else {
            open_ = hn::AndNot(stuck, open_);
        }
    }
    HWY_INLINE void end_unsure(M<Real> unsure) {
        if (hn::AllFalse(d<Real>, unsure)) return;
        unsure_ = hn::Or(unsure_, unsure);
        open_ = hn::AndNot(unsure, open_);
        tell(unsure, s_, s_, last_slope_);
    }
    HWY_INLINE void store() const {
        alignas(64) Real at[width], sides[width];
        hn::Store(s_, d<Real>, at);
        hn::Store(side_, d<Real>, sides);
        const LaneBits passed = bits_of(d<Real>, passed_);
        const LaneBits sure = bits_of(d<Real>, sure_);
        const LaneBits unsure = bits_of(d<Real>, unsure_);
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const std::size_t place = places_[i];
            BallRayState& state = block_.state[place];
            if (state != BallRayState::Open) continue;
            block_.side[place] = static_cast<std::int8_t>(sides[i]);
            block_.at[place] = std::max(block_.at[place], static_cast<double>(at[i]));
            if ((passed >> i & 1U) != 0) state = BallRayState::Passed;
            if ((sure >> i & 1U) != 0) state = BallRayState::Root;
            if ((unsure >> i & 1U) != 0) state = BallRayState::Unsure;
        }
    }

    const BallQuestion& question_;
    BallBlock& block_;
    const MarchBounds<Real>& bounds_;
    std::span<const std::uint8_t> places_;
    std::vector<Slot>& slots_;
    std::size_t count_ = 0, next_ = 0;
    double error_ = bounds_.base, slope_error_ = 0;
    double usual_ = question_.balls.empty() ? 1 : question_.balls.front().radius / bounds_.length;
    Real next_from_ = -unbounded;  ///< where the balls that are not taken in begin
    bool fresh_ = false;
    /// Whether a bracket is wide enough for this type to prove anything in it.
    bool tries_ = is_double || question_.bracket > 16 * bounds_.place_error;
    V<Real> bracket_ = number<Real>(question_.bracket);
    M<Real> open_, passed_, sure_, unsure_, above_, below_;
    VectorOfRays<Real> rays_ = {block_, places_};
    V<Real> s_, stop_;
    V<Real> side_, window_, level_;
    V<Real> last_slope_[3] = {zero(), zero(), zero()};
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
