// Rays in the axes of a packet: where they enter and leave the clip box, and their coordinates as
// lines over K, enclosed. All in double and in upward rounding, then rounded outward to the
// packet's type. Included once for each instruction set, after Highway.
//
// The exact ray of a pixel starts at the eye, in the direction that ViewFrame's numbers give
// without rounding. A computed component of a direction is off by at most 16 q (1 + u + v), where
// q = 2^-52 bounds the relative error of an operation and u, v are half the image's width and
// height: 5 q from the tile's corner, 8 q from the two steps to the pixel, 3 q from their sums.
// An error of the direction is multiplied by the distance from the eye, so that it vanishes in a
// deep view, where the eye is near.

#if defined(ZEROSET_K_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_RAYS_INL
#undef ZEROSET_K_RAYS_INL
#else
#define ZEROSET_K_RAYS_INL
#endif

#include "engine/trace/k_packet-inl.hpp"

#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// As many rays of a packet as there are doubles in a vector: a part of one in float, all of one in
/// double.
using D64 = Tag<double>;
using V64 = hn::Vec<D64>;
constexpr D64 d64{};
constexpr std::size_t part_lanes = lanes<double>;
template <class Real>
using PartTag = hn::Rebind<Real, D64>;
template <class Real>
using PartOf = hn::Vec<PartTag<Real>>;

/// Rounded upward.
template <class Real>
HWY_INLINE PartOf<Real> narrowed(V64 value) {
    if constexpr (std::is_same_v<Real, float>) {
        return hn::DemoteTo(PartTag<float>(), value);
    } else {
        return value;
    }
}
HWY_INLINE V64 widened(PartOf<float> value) { return hn::PromoteTo(d64, value); }
HWY_INLINE V64 widened(V64 value) { return value; }

/// Directions, and where the rays enter and leave the clip box: t from -neg_t_in to t_out.
struct PartRays {
    V64 direction[3];
    V64 inverse_k;
    V64 neg_t_in, t_out;

    [[nodiscard]] HWY_INLINE bool all_miss() const {
        return hn::AllTrue(d64, hn::Lt(hn::Add(neg_t_in, t_out), hn::Zero(d64)));
    }
    /// Bits of the rays for which the axes are good ones: K no shorter than a quarter of the
    /// others, none falling.
    [[nodiscard]] HWY_INLINE unsigned fitting() const {
        const V64 steepest = hn::Mul(hn::Set(d64, 4.0), direction[0]);
        const auto shallow = hn::Le(hn::Max(direction[1], direction[2]), steepest);
        const auto rising = hn::Ge(hn::Min(direction[1], direction[2]), hn::Zero(d64));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d64, hn::And(shallow, rising), bits);
        return bits[0];
    }
    /// Ends the rays where they leave the slab of an axis of the clip box. Any direction within the
    /// error may be the exact one.
    HWY_INLINE void clip(V64 axis_direction, double error, double from_lo, double to_hi);
};

HWY_INLINE void PartRays::clip(V64 axis_direction, double error, double from_lo, double to_hi) {
    const V64 zero = hn::Zero(d64);
    const V64 tiny = hn::Set(d64, 1e-300);
    const V64 bound = hn::Set(d64, error);
    // Negative directions are of rays that do not fit.
    const V64 fastest = hn::Max(hn::Add(axis_direction, bound), tiny);
    const V64 neg_slowest = hn::Sub(bound, axis_direction);
    const V64 slowest = hn::Neg(hn::IfThenElse(hn::Eq(neg_slowest, zero), tiny, neg_slowest));
    neg_t_in = hn::Min(neg_t_in, hn::Div(hn::Set(d64, from_lo), fastest));
    // A ray that may fall towards the upper end enters there, if it starts behind it.
    const V64 to_end = hn::Div(hn::Set(d64, to_hi), slowest);
    const auto rises = hn::Gt(slowest, zero);
    const V64 neg_to_end = hn::Div(hn::Set(d64, to_hi), hn::Neg(slowest));
    t_out = hn::IfThenElse(rises, hn::Min(t_out, to_end), t_out);
    neg_t_in = hn::IfThenElse(rises, neg_t_in, hn::Min(neg_t_in, neg_to_end));
}

/// The part of a packet from lane `first` on; `block` is the direction of its first pixel.
template <class Real>
HWY_INLINE PartRays part_of(const Axes<Real>& axes, const glm::dvec3& block, std::size_t first) {
    PartRays rays{};
    rays.neg_t_in = hn::Zero(d64);
    rays.t_out = hn::Set(d64, std::numeric_limits<double>::infinity());
    for (int i = 0; i < 3; ++i) {
        const int world = axes.world[i];
        const double corner = axes.mirrored[i] ? -block[world] : block[world];
        rays.direction[i] =
            hn::Add(hn::Set(d64, corner), hn::Load(d64, axes.lane_offset[i] + first));
        rays.clip(rays.direction[i], axes.direction_error, axes.from_lo[i], axes.to_hi[i]);
    }
    // What does not fit must not divide by 0.
    const V64 k = hn::Max(rays.direction[0], hn::Set(d64, 1e-300));
    rays.inverse_k = hn::Div(hn::Set(d64, 1.0), k);
    return rays;
}

/// Entries, exits and lines of a part, enclosed in numbers of the packet's type.
template <class Real>
struct PartLines {
    PartOf<Real> neg_k_in, k_out, stretch;
    PartOf<Real> slope[2], neg_lo[2], hi[2];
};

// A product that is to be rounded upward is always one that is added: without a fused
// multiply-add, the product of a - b c would be rounded the wrong way.
template <class Real>
HWY_INLINE PartLines<Real> lines_of(const Axes<Real>& axes, const PartRays& rays) {
    const V64 k_eye = hn::Set(d64, axes.eye[0]);
    const V64 neg_k_eye = hn::Neg(k_eye);
    const V64 bound = hn::Set(d64, axes.direction_error);
    const V64 neg_k_slowest = hn::Sub(bound, rays.direction[0]);
    const V64 k_fastest = hn::Add(bound, rays.direction[0]);
    PartLines<Real> lines{};
    lines.neg_k_in = narrowed<Real>(hn::MulAdd(hn::Neg(rays.neg_t_in), neg_k_slowest, neg_k_eye));
    lines.k_out = narrowed<Real>(hn::MulAdd(rays.t_out, k_fastest, k_eye));
    const V64 exact_error =
        hn::Mul(hn::Set(d64, axes.slope_error_share() * axes.k_reach), rays.inverse_k);
    V64 length2 = hn::Mul(rays.direction[0], rays.direction[0]);
    for (int i = 0; i < 2; ++i) {
        const V64 eye = hn::Set(d64, axes.eye[i + 1]);
        // A ray that falls within the error is taken for one that keeps its coordinate.
        const V64 slope = hn::Max(hn::Mul(rays.direction[i + 1], rays.inverse_k), hn::Zero(d64));
        lines.slope[i] = narrowed<Real>(slope);
        const V64 slope_error = hn::Sub(widened(lines.slope[i]), slope);
        const V64 error = hn::MulAdd(slope_error, hn::Set(d64, axes.k_size), exact_error);
        const V64 hi = hn::MulAdd(slope, neg_k_eye, eye);
        const V64 neg_lo = hn::MulAdd(slope, k_eye, hn::Neg(eye));
        lines.hi[i] = narrowed<Real>(hn::Add(hi, error));
        lines.neg_lo[i] = narrowed<Real>(hn::Add(neg_lo, error));
        length2 = hn::MulAdd(rays.direction[i + 1], rays.direction[i + 1], length2);
    }
    lines.stretch = hn::Div(hn::Sqrt(narrowed<Real>(length2)), narrowed<Real>(rays.direction[0]));
    return lines;
}

/// Puts the part from lane `first` on into the packet.
template <class Real>
HWY_INLINE void store_part(const PartLines<Real>& lines, std::size_t first, Packet<Real>& packet) {
    const PartTag<Real> tag;
    hn::Store(hn::Neg(lines.neg_k_in), tag, packet.k_in + first);
    hn::Store(lines.k_out, tag, packet.k_out + first);
    hn::Store(lines.stretch, tag, packet.stretch + first);
    for (int i = 0; i < 2; ++i) {
        Line<Real>& line = packet.line[i];
        hn::Store(lines.slope[i], tag, line.slope + first);
        hn::Store(lines.neg_lo[i], tag, line.neg_lo + first);
        hn::Store(lines.hi[i], tag, line.hi + first);
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
