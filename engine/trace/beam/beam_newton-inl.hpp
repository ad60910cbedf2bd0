// Newton's method on some rays at once: in the type of the tile's cells, then in double.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_NEWTON_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_NEWTON_INL
#undef ZEROSET_BEAM_NEWTON_INL
#else
#define ZEROSET_BEAM_NEWTON_INL
#endif

#include "engine/kernel/kernel.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstddef>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The error of f where it was evaluated in double; `r`: see FormBatchOf.
inline double value_error(double r) {
    return std::numeric_limits<double>::epsilon() * (1.0 + 0x1p-20) * r;
}

/// Some rays of a tile on their way to roots: the arrays of NewtonBatchOf and RayValueBatch. Plain
/// data, nothing of it set at first; functions take the first `count` rays, a multiple of
/// Kernel::lane_multiple.
template <class Real, std::size_t capacity>
struct NewtonRays {
    alignas(64) float col[capacity], row[capacity];
    alignas(64) Real from[capacity], to[capacity];  ///< where the root is looked for
    alignas(64) Real guess[capacity];
    alignas(64) Real gradient[3][capacity], per_slope[capacity];  ///< near the guess
    alignas(64) float float_per_slope[capacity];
    alignas(64) double s[capacity], f[capacity];  ///< the guess in double, and f there

    /// Up to `most` steps from the guesses: a help only, nothing rests on where they end.
    void take_steps(const TraceFrame& frame, const TileRays& rays, const Kernel& kernel,
                    std::size_t count, int most) {
        kernel.newton(NewtonBatchOf<Real>{.size = count,
                                          .col = col,
                                          .row = row,
                                          .from = from,
                                          .to = to,
                                          .rays = rays.kernel_rays<Real>(),
                                          .uniforms = frame.scene.uniforms.template points<Real>(),
                                          .small_step = static_cast<Real>(rays.small_step()),
                                          .more_steps = most - 1,
                                          .s = guess,
                                          .gradient = {gradient[0], gradient[1], gradient[2]},
                                          .per_slope = per_slope});
        for (std::size_t i = 0; i < count; ++i)
            float_per_slope[i] = static_cast<float>(per_slope[i]);
    }
    /// f at s in double, after so many steps there, by float_per_slope, that end between lo and hi.
    void evaluate(const TraceFrame& frame, const TileRays& rays, const Kernel& kernel,
                  std::size_t count, int steps = 0, double lo = 0.0, double hi = 0.0) {
        kernel.ray_value(RayValueBatch{.size = count,
                                       .col = col,
                                       .row = row,
                                       .per_slope = float_per_slope,
                                       .steps = steps,
                                       .lo = lo,
                                       .hi = hi,
                                       .s = s,
                                       .rays = rays.kernel_rays<double>(),
                                       .uniforms = frame.scene.uniforms.template points<double>(),
                                       .f = f});
    }
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
