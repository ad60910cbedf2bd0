// Where rays may meet a part of a patch, by its linear form: linear_zeros (patch_sight.hpp) for a
// vector of rays.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_PATCH_ZEROS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_PATCH_ZEROS_INL
#undef ZEROSET_PATCH_ZEROS_INL
#else
#define ZEROSET_PATCH_ZEROS_INL
#endif

#include "engine/real/lanes-inl.hpp"
#include "engine/trace/patch/patch_sight.hpp"
#include "engine/trace/patch/patch_tree.hpp"
#include "engine/trace/patch/sight_algebra-inl.hpp"

#include <hwy/highway.h>

#include <array>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The shift from the middle of a box to that of a half, and the share of a box that its part is.
constexpr double half_shift = 0.5 / form_growth;
constexpr double inner = form_inner;
constexpr double rounding = sight_rounding;

/// Two vectors of doubles as floats, and floats as doubles.
HWY_INLINE V<float> floats_of(V<double> lower, V<double> upper) {
    const hn::Rebind<float, Tag<double>> half;
    return hn::Combine(d<float>, hn::DemoteTo(half, upper), hn::DemoteTo(half, lower));
}
HWY_INLINE std::array<V<double>, 2> doubles_of(V<float> floats) {
    const hn::Rebind<float, Tag<double>> half;
    return {hn::PromoteTo(d<double>, hn::LowerHalf(half, floats)),
            hn::PromoteTo(d<double>, hn::UpperHalf(half, floats))};
}

/// The lanes where `wanted` holds, first. Highway 1.0 copies a table of 2 kB for each vector.
HWY_INLINE V<double> squeezed(V<double> numbers, M<double> wanted) {
#if HWY_TARGET <= HWY_AVX3
    return V<double>{_mm512_maskz_compress_pd(wanted.raw, numbers.raw)};
#else
    return hn::Compress(numbers, wanted);
#endif
}
HWY_INLINE V<float> squeezed(V<float> numbers, M<float> wanted) {
#if HWY_TARGET <= HWY_AVX3
    return V<float>{_mm512_maskz_compress_ps(wanted.raw, numbers.raw)};
#else
    return hn::Compress(numbers, wanted);
#endif
}

/// Where the zeros of g may be, by the linear form; `none`: there are none.
struct Zeros {
    M<float> none, known;
    V<float> p, q;
    V<float> radius;           ///< of both, where they are known
    V<float> lost;             ///< the part of it by rounding
    Matrix2<V<float>> slopes;  ///< of g by the linear form
};

/// linear_zeros of a leaf in float, with its numbers in vectors. In upward rounding.
class LinearForm {
public:
    /// More than what the rounding of some tens of operations may take from floats, relative to
    /// the sizes that go in.
    static constexpr double float_rounding = 0x1p-20;

    HWY_INLINE LinearForm(const PatchSight& sight, const SightAxes& axes)
        : c_(in_axes<V<float>>(sight.c)),
          kp_(in_axes<V<float>>(sight.kp)),
          kq_(in_axes<V<float>>(sight.kq)),
          distance_(number<float>(axes.distance)) {
        // The numbers as floats are as good as those of a linear form that is so far from this one.
        const glm::dvec3 sizes = glm::abs(sight.c) + glm::abs(sight.kp) + glm::abs(sight.kq) +
                                 glm::dvec3(0.0, 0.0, axes.distance);
        e_ = in_axes<V<float>>(sight.e + float_rounding * sizes);
    }

    HWY_INLINE Zeros zeros(const SightLine<V<float>>& ray) const {
        const LinearG<V<float>> g = linear_g(ray, c_, kp_, kq_, e_, distance_);
        const Zeros2<V<float>> of = zeros_of(divisor_of(g.slopes), g.middle);
        const auto& [p, q] = of.x;
        const V<float> share = number<float>(inner);
        const M<float> beyond = hn::Or(hn::Gt(hn::Sub(hn::Abs(p.middle), p.radius), share),
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
    InAxes<V<float>> c_, kp_, kq_, e_;
    V<float> distance_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
