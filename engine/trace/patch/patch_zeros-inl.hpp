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
#include "engine/trace/patch/sight_algebra-inl.hpp"
#include "engine/trace/simd/vectors-inl.hpp"

#include <hwy/highway.h>

#include <array>
#include <cstddef>

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
    Floats radius;           ///< of both, where they are known
    Floats lost;             ///< the part of it by rounding
    Matrix2<Floats> slopes;  ///< of g by the linear form
};

/// linear_zeros of a leaf in float, with its numbers in vectors. In upward rounding.
class LinearForm {
public:
    /// More than what the rounding of some tens of operations may take from floats, relative to
    /// the sizes that go in.
    static constexpr double float_rounding = 0x1p-20;

    HWY_INLINE LinearForm(const PatchSight& sight, const SightAxes& axes)
        : c_(in_axes<Floats>(sight.c)),
          kp_(in_axes<Floats>(sight.kp)),
          kq_(in_axes<Floats>(sight.kq)),
          distance_(float_number(axes.distance)) {
        // The numbers as floats are as good as those of a linear form that is so far from this one.
        const glm::dvec3 sizes = glm::abs(sight.c) + glm::abs(sight.kp) + glm::abs(sight.kq) +
                                 glm::dvec3(0.0, 0.0, axes.distance);
        e_ = in_axes<Floats>(sight.e + float_rounding * sizes);
    }

    HWY_INLINE Zeros zeros(const SightLine<Floats>& ray) const {
        const LinearG<Floats> g = linear_g(ray, c_, kp_, kq_, e_, distance_);
        const Zeros2<Floats> of = zeros_of(divisor_of(g.slopes), g.middle);
        const auto& [p, q] = of.x;
        const Floats share = float_number(inner);
        const FloatMask beyond = hn::Or(hn::Gt(hn::Sub(hn::Abs(p.middle), p.radius), share),
                                        hn::Gt(hn::Sub(hn::Abs(q.middle), q.radius), share));
        return {.none = hn::Or(g.misses(inner), hn::And(of.known, beyond)),
                .known = of.known,
                .p = p.middle,
                .q = q.middle,
                .radius = hn::Max(p.radius, q.radius),
                .lost = of.lost,
                .slopes = g.slopes};
    }

private:
    InAxes<Floats> c_, kp_, kq_, e_;
    Floats distance_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
