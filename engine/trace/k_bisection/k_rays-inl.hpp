// Rays in the axes of a packet: where they enter and leave the clip box and the region, and their
// coordinates as lines over K, enclosed. All in double and in upward rounding, then rounded outward
// to the packet's type. Included once for each instruction set, after Highway.
//
// The exact ray of a pixel starts at the eye, in the direction that ViewFrame's numbers give
// without rounding. A computed component of a direction is off by at most 16 q (1 + u + v), where
// q = 2^-52 bounds the relative error of an operation and u, v are half the image's width and
// height: 5 q from the tile's corner, 8 q from the two steps to the pixel, 3 q from their sums.
// An error of the direction is multiplied by the distance from the eye, so that it vanishes in a
// deep view, where the eye is near. Parallel rays have one direction, without error; what is
// computed of a start is taken for the exact one.

#if defined(ZEROSET_K_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_RAYS_INL
#undef ZEROSET_K_RAYS_INL
#else
#define ZEROSET_K_RAYS_INL
#endif

#include "engine/trace/k_bisection/k_packet-inl.hpp"
#include "engine/trace/simd/region_clip-inl.hpp"

#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The rays of a packet that make a part: as many as there are doubles in a vector, some of the
/// packet in float, all of it in double.
constexpr std::size_t part_lanes = lanes<double>;
template <class Real>
using PartTag = hn::Rebind<Real, Tag<double>>;
template <class Real>
using PartOf = hn::Vec<PartTag<Real>>;

/// Rounds to the packet's type, upward.
template <class Real>
HWY_INLINE PartOf<Real> narrowed(V<double> value) {
    if constexpr (std::is_same_v<Real, float>) {
        return hn::DemoteTo(PartTag<float>(), value);
    } else {
        return value;
    }
}
HWY_INLINE V<double> widened(PartOf<float> value) { return hn::PromoteTo(d<double>, value); }
HWY_INLINE V<double> widened(V<double> value) { return value; }

/// Where rays enter and leave the clip box: t from -neg_in to out.
struct PartSpan {
    V<double> neg_in, out;
};

/// Starts, directions and spans, in a packet's axes.
struct PartRays {
    V<double> start[3], direction[3];
    V<double> inverse_k;
    PartSpan span;

    [[nodiscard]] HWY_INLINE bool all_miss() const {
        return hn::AllTrue(d<double>, hn::Lt(hn::Add(span.neg_in, span.out), hn::Zero(d<double>)));
    }
    /// Bits of the rays for which the axes are good ones: K no shorter than a quarter of the
    /// others, none falling.
    [[nodiscard]] HWY_INLINE unsigned fitting() const {
        const V<double> steepest = hn::Mul(number(4.0), direction[0]);
        const auto shallow = hn::Le(hn::Max(direction[1], direction[2]), steepest);
        const auto rising = hn::Ge(hn::Min(direction[1], direction[2]), hn::Zero(d<double>));
        return bits_of(d<double>, hn::And(shallow, rising));
    }
};

/// An axis of the clip box as its rays see it: the slab's ends from their starts, a bound for the
/// error of directions. Any direction within the error may be the exact one.
struct Slab {
    V<double> from_lo, to_hi;
    double error;
};

/// Ends the spans within the slab where some ray may be parallel to it.
HWY_NOINLINE PartSpan clip_parallel(PartSpan span, const Slab& slab, V<double> direction) {
    const V<double> zero = hn::Zero(d<double>);
    const V<double> tiny = number(1e-300);
    const V<double> bound = number(slab.error);
    // Negative directions are of rays that do not fit.
    const V<double> fastest = hn::Max(hn::Add(direction, bound), tiny);
    const V<double> neg_difference = hn::Sub(bound, direction);
    const V<double> neg_slowest =
        hn::IfThenElse(hn::Eq(neg_difference, zero), tiny, neg_difference);
    const V<double> neg_in = hn::Min(span.neg_in, hn::Div(slab.from_lo, fastest));
    // A ray that may fall towards the upper end enters there, if it starts behind it.
    const auto rises = hn::Lt(neg_slowest, zero);
    const V<double> to_end = hn::Div(slab.to_hi, hn::Neg(neg_slowest));
    const V<double> neg_to_end = hn::Div(slab.to_hi, neg_slowest);
    return {.neg_in = hn::IfThenElse(rises, neg_in, hn::Min(neg_in, neg_to_end)),
            .out = hn::IfThenElse(rises, hn::Min(span.out, to_end), span.out)};
}

/// Ends the spans where the rays leave the slab. Returns 1 / (direction - error).
HWY_INLINE V<double> clip(PartSpan& span, const Slab& slab, V<double> direction) {
    const V<double> one = number(1.0);
    const V<double> slowest = hn::Neg(hn::Sub(number(slab.error), direction));
    if (HWY_UNLIKELY(!hn::AllTrue(d<double>, hn::Gt(slowest, hn::Zero(d<double>))))) {
        span = clip_parallel(span, slab, direction);
        return hn::Div(one, hn::Max(slowest, number(1e-300)));
    }
    const V<double> longest = hn::Div(one, slowest);
    // The shortest is no less than longest (1 - 2 error longest), but for an ulp.
    const V<double> neg_share =
        hn::MulAdd(number(2.0 * slab.error), longest, number(0x1p-50 - 1.0));
    const V<double> neg_shortest = hn::Mul(longest, neg_share);
    span.neg_in = hn::Min(span.neg_in, hn::Mul(hn::Neg(slab.from_lo), neg_shortest));
    span.out = hn::Min(span.out, hn::Mul(slab.to_hi, longest));
    return longest;
}

/// Ends the spans where the rays leave the region.
template <class Real>
HWY_NOINLINE void clip_region(const Axes<Real>& axes, PartRays& rays) {
    RayVectors<Tag<double>> lines;
    for (int i = 0; i < 3; ++i) {
        const int world = axes.world[i];
        lines.origin[world] = axes.mirrored[i] ? hn::Neg(rays.start[i]) : rays.start[i];
        lines.direction[world] = axes.mirrored[i] ? hn::Neg(rays.direction[i]) : rays.direction[i];
    }
    InsideSpans<Tag<double>> inside(0.0, 0.0);
    for (const Section& section : axes.region->sections)
        inside.keep(section, axes.place_error + 0x1p-46 * size_of(section), lines);
    if (const auto& ball = axes.region->ball)
        inside.keep(*ball, axes.place_error + 0x1p-46 * size_of(*ball), lines);
    rays.span.neg_in = hn::Min(rays.span.neg_in, hn::Neg(inside.enter_lo));
    rays.span.out = hn::Min(rays.span.out, inside.exit_hi);
}

/// The part of a packet from lane `first` on; `start` and `direction` are those of its first pixel.
template <class Real>
HWY_INLINE PartRays part_of(const Axes<Real>& axes, const glm::dvec3& start,
                            const glm::dvec3& direction, std::size_t first) {
    PartRays rays{};
    rays.span = {.neg_in = hn::Zero(d<double>),
                 .out = number(std::numeric_limits<double>::infinity())};
    for (int i = 0; i < 3; ++i) {
        const int world = axes.world[i];
        const double sign = axes.mirrored[i] ? -1.0 : 1.0;
        const V<double> offset = hn::Load(d<double>, axes.lane_offset[i] + first);
        rays.start[i] = number(sign * start[world]);
        rays.direction[i] = number(sign * direction[world]);
        V<double>& moves = axes.parallel ? rays.start[i] : rays.direction[i];
        moves = hn::Add(moves, offset);
        const Slab slab{hn::Sub(rays.start[i], number(axes.box_lo[i])),
                        hn::Sub(number(axes.box_hi[i]), rays.start[i]), axes.direction_error};
        const V<double> inverse = clip(rays.span, slab, rays.direction[i]);
        if (i == 0) {
            // 1 / direction but for the square of the error.
            const V<double> share = hn::Mul(number(-axes.direction_error), inverse);
            rays.inverse_k = hn::MulAdd(inverse, share, inverse);
        }
    }
    if (!axes.region->is_whole()) clip_region(axes, rays);
    return rays;
}

/// A coordinate of a part as lines over K, as in AxisLines.
template <class Real>
struct PartLine {
    PartOf<Real> slope_lo, slope_hi, neg_lo, hi;
};

// A product that is to be rounded upward is always one that is added: without a fused
// multiply-add, the product of a - b c would be rounded the wrong way.

/// The line of axis i, not K. In float the slopes' errors widen the lines by the same everywhere in
/// the box: that of rounding to float, much the largest, is small in the box, not at the eye. In
/// double those of the direction are left, which are smallest at the eye.
HWY_INLINE PartLine<float> line_of(const Axes<float>& axes, int i, const PartRays& rays) {
    const V<double> k_start = rays.start[0];
    const V<double> start = rays.start[i];
    // A ray that falls within the error is taken for one that keeps its coordinate.
    const V<double> slope =
        hn::Max(hn::Mul(rays.direction[i], rays.inverse_k), hn::Zero(d<double>));
    const PartOf<float> narrow = narrowed<float>(slope);
    const V<double> narrowing = hn::Sub(widened(narrow), slope);
    const V<double> of_direction =
        hn::Mul(number(axes.slope_error_share() * axes.k_reach), rays.inverse_k);
    const V<double> error = hn::MulAdd(narrowing, number(axes.k_size), of_direction);
    const V<double> neg_lo = hn::MulAdd(slope, k_start, hn::Neg(start));
    const V<double> hi = hn::MulAdd(slope, hn::Neg(k_start), start);
    return {.slope_lo = narrow,
            .slope_hi = narrow,
            .neg_lo = narrowed<float>(hn::Add(neg_lo, error)),
            .hi = narrowed<float>(hn::Add(hi, error))};
}

HWY_INLINE PartLine<double> line_of(const Axes<double>& axes, int i, const PartRays& rays) {
    const V<double> k_start = rays.start[0];
    const V<double> start = rays.start[i];
    const V<double> slope = hn::Mul(rays.direction[i], rays.inverse_k);
    const V<double> error = hn::Mul(number(axes.slope_error_share()), rays.inverse_k);
    const V<double> slope_hi = hn::Add(slope, error);
    const V<double> slope_lo = hn::Neg(hn::Sub(error, slope));
    return {.slope_lo = slope_lo,
            .slope_hi = slope_hi,
            .neg_lo = hn::MulAdd(slope_lo, k_start, hn::Neg(start)),
            .hi = hn::MulAdd(slope_hi, hn::Neg(k_start), start)};
}

/// Puts the part from lane `first` on into the packet, in numbers of its type that enclose it.
template <class Real>
HWY_INLINE void store_part(const PartRays& rays, std::size_t first, Packet<Real>& packet) {
    const PartTag<Real> tag;
    const Axes<Real>& axes = *packet.axes;
    const V<double> k_start = rays.start[0];
    const V<double> bound = number(axes.direction_error);
    const V<double> neg_slowest = hn::Sub(bound, rays.direction[0]);
    const V<double> fastest = hn::Add(bound, rays.direction[0]);
    const V<double> neg_k_in = hn::MulAdd(hn::Neg(rays.span.neg_in), neg_slowest, hn::Neg(k_start));
    hn::Store(hn::Neg(narrowed<Real>(neg_k_in)), tag, packet.k_in + first);
    hn::Store(narrowed<Real>(hn::MulAdd(rays.span.out, fastest, k_start)), tag,
              packet.k_out + first);
    hn::Store(narrowed<Real>(k_start), tag, packet.k_start + first);
    V<double> length2 = hn::Mul(rays.direction[0], rays.direction[0]);
    for (int i = 1; i < 3; ++i) {
        const PartLine<Real> part = line_of(axes, i, rays);
        AxisLines<Real>& line = packet.line[i - 1];
        hn::Store(part.slope_lo, tag, line.slope_lo + first);
        hn::Store(part.slope_hi, tag, line.slope_hi + first);
        hn::Store(part.neg_lo, tag, line.neg_lo + first);
        hn::Store(part.hi, tag, line.hi + first);
        length2 = hn::MulAdd(rays.direction[i], rays.direction[i], length2);
    }
    const PartOf<Real> length = hn::Sqrt(narrowed<Real>(length2));
    hn::Store(hn::Div(length, narrowed<Real>(rays.direction[0])), tag, packet.stretch + first);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
