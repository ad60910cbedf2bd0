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

#include <cstddef>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

using D = Tag<double>;
using Vector = V<double>;
using Mask = M<double>;
constexpr std::size_t width = lanes<double>;

/// How much of a box its form stands for; wider than what rounding may take from it.
constexpr double half_shift = 0.5 / form_growth;
constexpr double inner = (1.0 + 0x1p-20) / form_growth;
constexpr double rounding = sight_rounding;

HWY_INLINE Vector number(double x) { return hn::Set(D(), x); }

/// The lanes where `wanted` holds, first. Highway 1.0 copies a table of 2 kB for each vector.
HWY_INLINE Vector squeezed(Vector numbers, Mask wanted) {
#if HWY_TARGET <= HWY_AVX3
    return Vector{_mm512_maskz_compress_pd(wanted.raw, numbers.raw)};
#else
    return hn::Compress(numbers, wanted);
#endif
}

/// Where the zeros of g may be, by the linear form; `none`: there are none.
struct Zeros {
    Mask none, known;
    Vector p, q;
    Vector radius;  ///< of both, where they are known
};

/// linear_zeros of a leaf, with its numbers in vectors.
class LinearForm {
public:
    HWY_INLINE LinearForm(const PatchSight& sight, const SightAxes& axes)
        : c_(spread(sight.c)),
          kp_(spread(sight.kp)),
          kq_(spread(sight.kq)),
          e_(spread(sight.e)),
          distance_(number(axes.distance)) {}

    HWY_INLINE Zeros zeros(Vector u, Vector v) const {
        const Vector g1 = hn::NegMulAdd(u, c_.z, hn::NegMulAdd(u, distance_, c_.x));
        const Vector g2 = hn::NegMulAdd(v, c_.z, hn::NegMulAdd(v, distance_, c_.y));
        const Vector pp = hn::NegMulAdd(u, kp_.z, kp_.x);
        const Vector pq = hn::NegMulAdd(u, kq_.z, kq_.x);
        const Vector qp = hn::NegMulAdd(v, kp_.z, kp_.y);
        const Vector qq = hn::NegMulAdd(v, kq_.z, kq_.y);
        const Vector e1 = hn::MulAdd(hn::Abs(u), e_.z, e_.x);
        const Vector e2 = hn::MulAdd(hn::Abs(v), e_.z, e_.y);
        const Vector wider = number(1.0 + rounding);
        const Vector reach1 = hn::MulAdd(hn::Add(hn::Abs(pp), hn::Abs(pq)), wider, e1);
        const Vector reach2 = hn::MulAdd(hn::Add(hn::Abs(qp), hn::Abs(qq)), wider, e2);
        const Mask beside = hn::Or(hn::Gt(hn::Abs(g1), reach1), hn::Gt(hn::Abs(g2), reach2));
        const Vector first = hn::Mul(pp, qq);
        const Vector second = hn::Mul(pq, qp);
        const Vector determinant = hn::Sub(first, second);
        const Vector size = hn::Add(hn::Abs(first), hn::Abs(second));
        const Vector inverse = hn::Div(number(1.0), determinant);
        const Vector grow = hn::Mul(hn::Abs(inverse), number(1.0 + 0x1p-10));
        const Vector lost = hn::Mul(hn::Mul(number(rounding), size), grow);
        const auto radius = [&](Vector a, Vector b, Vector ga, Vector gb) HWY_ATTR {
            const Vector forms = hn::Mul(hn::MulAdd(a, e1, hn::Mul(b, e2)), grow);
            const Vector terms = hn::Add(hn::Abs(ga), hn::Abs(gb));
            return hn::MulAdd(hn::Mul(lost, terms), grow, forms);
        };
        const Vector p1 = hn::Mul(pq, g2);
        const Vector p2 = hn::Mul(qq, g1);
        const Vector q1 = hn::Mul(qp, g1);
        const Vector q2 = hn::Mul(pp, g2);
        Zeros zeros{};
        zeros.p = hn::Mul(hn::Sub(p1, p2), inverse);
        zeros.q = hn::Mul(hn::Sub(q1, q2), inverse);
        const Vector p_radius = radius(hn::Abs(qq), hn::Abs(pq), p1, p2);
        const Vector q_radius = radius(hn::Abs(qp), hn::Abs(pp), q1, q2);
        zeros.known =
            hn::And(hn::Gt(hn::Abs(determinant), hn::Mul(number(0x1p-30), size)),
                    hn::Lt(hn::Add(e1, e2), number(std::numeric_limits<double>::infinity())));
        const Mask beyond = hn::Or(hn::Gt(hn::Sub(hn::Abs(zeros.p), p_radius), number(inner)),
                                   hn::Gt(hn::Sub(hn::Abs(zeros.q), q_radius), number(inner)));
        zeros.none = hn::Or(beside, hn::And(zeros.known, beyond));
        zeros.radius = hn::Max(p_radius, q_radius);
        return zeros;
    }

private:
    struct Place {
        Vector x, y, z;
    };
    static HWY_INLINE Place spread(const glm::dvec3& at) {
        return {.x = number(at.x), .y = number(at.y), .z = number(at.z)};
    }

    Place c_, kp_, kq_, e_;
    Vector distance_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
