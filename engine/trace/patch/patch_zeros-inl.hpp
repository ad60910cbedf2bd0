// Where rays may meet a part of a patch, by its linear form: linear_zeros (patch_sight.hpp) for a
// vector of rays.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_PATCH_ZEROS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_PATCH_ZEROS_INL
#undef ZEROSET_PATCH_ZEROS_INL
#else
#define ZEROSET_PATCH_ZEROS_INL
#endif

#include "engine/trace/patch/patch_sight.hpp"
#include "engine/trace/patch/patch_tree.hpp"
#include "engine/trace/simd/vectors-inl.hpp"

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

using D = Tag<double>;
using Vector = V<double>;
using Mask = M<double>;
constexpr std::size_t width = lanes<double>;

/// The shift from the middle of a box to that of a half, and the share of a box that its part is.
constexpr double half_shift = 0.5 / form_growth;
constexpr double inner = form_inner;
constexpr double rounding = sight_rounding;

HWY_INLINE Vector number(double x) { return hn::Set(D(), x); }

/// A vector of floats for the rays of two vectors of doubles.
using Floats = hn::Vec<hn::CappedTag<float, 2 * width>>;
using FloatMask = hn::Mask<hn::CappedTag<float, 2 * width>>;
constexpr hn::CappedTag<float, 2 * width> df{};

HWY_INLINE Floats float_number(double x) { return hn::Set(df, static_cast<float>(x)); }

/// Two vectors of doubles as floats, and floats as doubles.
HWY_INLINE Floats floats_of(Vector lower, Vector upper) {
    const hn::Rebind<float, D> half;
    return hn::Combine(df, hn::DemoteTo(half, upper), hn::DemoteTo(half, lower));
}
HWY_INLINE std::array<Vector, 2> doubles_of(Floats floats) {
    const hn::Rebind<float, D> half;
    const D d;
    return {hn::PromoteTo(d, hn::LowerHalf(half, floats)),
            hn::PromoteTo(d, hn::UpperHalf(half, floats))};
}

/// bits_of and mask_of without a way through memory.
template <class Tag>
HWY_INLINE LaneBits lanes_of(Tag tag, hn::Mask<Tag> mask) {
#if HWY_TARGET <= HWY_AVX3
    static_cast<void>(tag);
    return static_cast<LaneBits>(mask.raw);
#else
    return bits_of(tag, mask);
#endif
}
template <class Tag>
HWY_INLINE hn::Mask<Tag> lanes_at(Tag tag, LaneBits bits) {
#if HWY_TARGET <= HWY_AVX3
    static_cast<void>(tag);
    return {static_cast<decltype(hn::Mask<Tag>::raw)>(bits)};
#else
    return mask_of(tag, bits);
#endif
}

/// The lanes where `wanted` holds, first. Highway 1.0 copies a table of 2 kB for each vector.
HWY_INLINE Vector squeezed(Vector numbers, Mask wanted) {
#if HWY_TARGET <= HWY_AVX3
    return Vector{_mm512_maskz_compress_pd(wanted.raw, numbers.raw)};
#else
    return hn::Compress(numbers, wanted);
#endif
}
HWY_INLINE Floats squeezed(Floats numbers, FloatMask wanted) {
#if HWY_TARGET <= HWY_AVX3
    return Floats{_mm512_maskz_compress_ps(wanted.raw, numbers.raw)};
#else
    return hn::Compress(numbers, wanted);
#endif
}

/// Where the zeros of g may be, by the linear form; `none`: there are none.
struct Zeros {
    FloatMask none, known;
    Floats p, q;
    Floats radius;          ///< of both, where they are known
    Floats lost;            ///< the part of it by rounding
    Floats pp, pq, qp, qq;  ///< the slopes of g by the linear form
};

/// linear_zeros of a leaf in float, with its numbers in vectors. In upward rounding.
class LinearForm {
public:
    struct Place {
        Floats x, y, z;
    };
    static HWY_INLINE Place spread(const glm::dvec3& at) {
        return {.x = float_number(at.x), .y = float_number(at.y), .z = float_number(at.z)};
    }
    /// More than what the rounding of some tens of operations may take from floats, relative to
    /// the sizes that go in.
    static constexpr double float_rounding = 0x1p-20;

    HWY_INLINE LinearForm(const PatchSight& sight, const SightAxes& axes)
        : c_(spread(sight.c)),
          kp_(spread(sight.kp)),
          kq_(spread(sight.kq)),
          distance_(float_number(axes.distance)) {
        // The numbers as floats are as good as those of a linear form that is so far from this one.
        const glm::dvec3 sizes = glm::abs(sight.c) + glm::abs(sight.kp) + glm::abs(sight.kq) +
                                 glm::dvec3(0.0, 0.0, axes.distance);
        e_ = spread(sight.e + float_rounding * sizes);
    }

    HWY_INLINE Zeros zeros(Floats u, Floats v) const {
        const Floats g1 = hn::NegMulAdd(u, c_.z, hn::NegMulAdd(u, distance_, c_.x));
        const Floats g2 = hn::NegMulAdd(v, c_.z, hn::NegMulAdd(v, distance_, c_.y));
        const Floats pp = hn::NegMulAdd(u, kp_.z, kp_.x);
        const Floats pq = hn::NegMulAdd(u, kq_.z, kq_.x);
        const Floats qp = hn::NegMulAdd(v, kp_.z, kp_.y);
        const Floats qq = hn::NegMulAdd(v, kq_.z, kq_.y);
        const Floats e1 = hn::MulAdd(hn::Abs(u), e_.z, e_.x);
        const Floats e2 = hn::MulAdd(hn::Abs(v), e_.z, e_.y);
        // Reject rays on which the linear form of g is not 0 anywhere.
        const Floats wider = float_number(inner * (1.0 + float_rounding));
        const Floats reach1 = hn::MulAdd(hn::Add(hn::Abs(pp), hn::Abs(pq)), wider, e1);
        const Floats reach2 = hn::MulAdd(hn::Add(hn::Abs(qp), hn::Abs(qq)), wider, e2);
        const FloatMask beside = hn::Or(hn::Gt(hn::Abs(g1), reach1), hn::Gt(hn::Abs(g2), reach2));
        // Solve the linear system, with bounds of the error.
        const Floats first = hn::Mul(pp, qq);
        const Floats second = hn::Mul(pq, qp);
        const Floats determinant = hn::Sub(first, second);
        const Floats size = hn::Add(hn::Abs(first), hn::Abs(second));
        const Floats inverse = hn::Div(float_number(1.0), determinant);
        const Floats grow = hn::Mul(hn::Abs(inverse), float_number(1.0 + 0x1p-8));
        const Floats lost = hn::Mul(hn::Mul(float_number(float_rounding), size), grow);
        const auto radius = [&](Floats a, Floats b, Floats ga, Floats gb) HWY_ATTR {
            const Floats forms = hn::Mul(hn::MulAdd(a, e1, hn::Mul(b, e2)), grow);
            const Floats terms = hn::Add(hn::Abs(ga), hn::Abs(gb));
            return hn::MulAdd(hn::Mul(lost, terms), grow, forms);
        };
        const Floats p1 = hn::Mul(pq, g2);
        const Floats p2 = hn::Mul(qq, g1);
        const Floats q1 = hn::Mul(qp, g1);
        const Floats q2 = hn::Mul(pp, g2);
        Zeros zeros{};
        zeros.p = hn::Mul(hn::Sub(p1, p2), inverse);
        zeros.q = hn::Mul(hn::Sub(q1, q2), inverse);
        const Floats p_radius = radius(hn::Abs(qq), hn::Abs(pq), p1, p2);
        const Floats q_radius = radius(hn::Abs(qp), hn::Abs(pp), q1, q2);
        const Floats unbounded = float_number(std::numeric_limits<double>::infinity());
        zeros.radius = hn::Max(p_radius, q_radius);
        zeros.lost = hn::Mul(hn::Mul(lost, grow), hn::Max(hn::Add(hn::Abs(p1), hn::Abs(p2)),
                                                          hn::Add(hn::Abs(q1), hn::Abs(q2))));
        zeros.pp = pp;
        zeros.pq = pq;
        zeros.qp = qp;
        zeros.qq = qq;
        // Products of small numbers may be 0, those of large ones end below at the least finite
        // one.
        const FloatMask is_moderate = hn::And(hn::Gt(hn::Abs(determinant), float_number(0x1p-80)),
                                              hn::Lt(size, float_number(0x1p120)));
        zeros.known = hn::And(hn::And(is_moderate, hn::Gt(hn::Abs(determinant),
                                                          hn::Mul(float_number(0x1p-10), size))),
                              hn::And(hn::Lt(p_radius, unbounded), hn::Lt(q_radius, unbounded)));
        const FloatMask beyond =
            hn::Or(hn::Gt(hn::Sub(hn::Abs(zeros.p), p_radius), float_number(inner)),
                   hn::Gt(hn::Sub(hn::Abs(zeros.q), q_radius), float_number(inner)));
        zeros.none = hn::Or(beside, hn::And(zeros.known, beyond));
        return zeros;
    }

private:
    Place c_, kp_, kq_, e_;
    Floats distance_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
