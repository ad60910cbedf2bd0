#include "engine/real/rounding.hpp"
#include "engine/real/sleef_lanes.hpp"

#include <immintrin.h>
#include <sleef.h>

// A plain number as a lane of a register: SLEEF's own functions over plain numbers without fused
// multiply-add ("purec") have other bits than those over registers, as sin of a float near pi/2.

namespace zeroset {
namespace {

__m128 filled_with(float a) { return _mm_set1_ps(a); }
__m128d filled_with(double a) { return _mm_set1_pd(a); }
float first_of(const __m128& lanes) { return _mm_cvtss_f32(lanes); }
double first_of(const __m128d& lanes) { return _mm_cvtsd_f64(lanes); }

/// A function over plain numbers, of one over registers; it is one of these.
template <class Real, auto function>
struct OneLane {
    static Real of_one(Real a) { return first_of(function(filled_with(a))); }
    static Real of_two(Real a, Real b) {
        return first_of(function(filled_with(a), filled_with(b)));
    }
};

template <class Real, auto function>
constexpr auto one_lane_of() {
    if constexpr (requires(Real a) { function(filled_with(a)); })
        return &OneLane<Real, function>::of_one;
    else
        return &OneLane<Real, function>::of_two;
}

}  // namespace
}  // namespace zeroset

#define LOOKUP sleef_plain

#define REAL float
#define VECTOR float
#define NAME(name, accuracy) *one_lane_of<REAL, Sleef_cinz_##name##f4_##accuracy##sse2>()
#include "engine/real/sleef_lanes.inc"

#define REAL double
#define VECTOR double
#define NAME(name, accuracy) *one_lane_of<REAL, Sleef_cinz_##name##d2_##accuracy##sse2>()
#include "engine/real/sleef_lanes.inc"
