#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace zeroset {

/// Batches hold a multiple of this many items, whatever the lanes of the code that runs them.
inline constexpr std::size_t batch_multiple = 16;

/// `size` up to a multiple of `multiple`.
constexpr std::size_t padded(std::size_t size, std::size_t multiple = batch_multiple) {
    return (size + multiple - 1) / multiple * multiple;
}

/// A word that tells of a box whether f is continuous there: as wide as the numbers beside it.
template <class Real>
using ContinuityMask = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

/// Pieces of a function with switches (engine/algebra/switches.hpp): for each item, which switches
/// are held at one of the outcomes that they have in its box. Three bits a switch,
/// `switches_a_word` in a word, see `held_code`. Where a switch has another number of outcomes it
/// is not held.
template <class Real>
struct HeldSwitches {
    const ContinuityMask<Real>* words = nullptr;  ///< word w of item i at w * stride + i; nullptr:
    std::size_t stride = 0;                       ///< no switch of any item is held
};
inline constexpr std::size_t held_bits = 3;
template <class Real>
inline constexpr std::size_t switches_a_word = 8 * sizeof(ContinuityMask<Real>) / held_bits;

/// Outcome 0, 1 or 2, from the lowest on, of two or three: 1 and 2, or 3, 4 and 5. 0: not held.
constexpr unsigned held_code(unsigned outcome, unsigned outcomes) {
    return (outcomes == 2 ? 1 : 3) + outcome;
}

/// The branches of f in a box: whether it may hold a kink (of abs, min, max), and the first switch
/// that has more than one outcome there, at most three.
struct BranchBits {
    static constexpr unsigned kink = 1;
    static constexpr unsigned more_outcomes_shift = 1;  ///< two bits: the outcomes but one
    static constexpr unsigned switch_shift = 3;

    std::uint32_t bits;

    [[nodiscard]] bool may_hold_kink() const { return (bits & kink) != 0; }
    /// 0: all switches are decided, or the first that is not has more than three outcomes.
    [[nodiscard]] unsigned outcomes() const {
        const unsigned more = bits >> more_outcomes_shift & 3U;
        return more == 0 ? 0 : more + 1;
    }
    [[nodiscard]] std::size_t open_switch() const { return bits >> switch_shift; }
};

/// `size` boxes in x, y, z; arrays of `size` numbers, in structure-of-arrays form.
template <class Real>
struct RangeBatchOf {
    std::size_t size;       ///< a multiple of batch_multiple, not 0
    const Real* neg_lo[3];  ///< -lo of x, y, z: of whatever boxes (engine/num/interval.hpp)
    const Real* hi[3];      ///< hi of x, y, z
    const Real* uniforms;   ///< Uniforms::boxes
    /// out: -lo and hi of an enclosure of f over the box. Where both are below 0, f is at most hi
    /// or at least lo there, and so never 0; where both are -inf, f is nowhere defined; NaN:
    /// unknown.
    Real* f_neg_lo;
    Real* f_hi;
    /// out: all ones where f is proved defined and continuous, else 0
    ContinuityMask<Real>* continuous;
    HeldSwitches<Real> held = {};  ///< in: then all this is said of a piece
    /// out, if Kernel::branches: BranchBits; nullptr: not asked for
    ContinuityMask<Real>* branches = nullptr;
};

/// `size` points.
template <class Real>
struct ValueBatchOf {
    std::size_t size;      ///< a multiple of batch_multiple, not 0
    const Real* x[3];      ///< x, y, z
    const Real* uniforms;  ///< Uniforms::points
    Real* f;               ///< out: f, not rounded outward
    Real* gradient[3];     ///< out: df/dx, df/dy, df/dz
};

/// The place of a batch of cells in the world: the point at depth s on the ray of (u, v) is
///   base + (distance + s) (u right + v up) + s forward.
/// Only numbers: kernels take it as an array.
template <class Real>
struct FrustumOf {
    Real base[3], right[3], up[3], forward[3];
    Real distance;            ///< from the eye to the plane s = 0 through `base`
    Real u_radius, v_radius;  ///< of every cell
    /// Upper bounds of the sizes of the terms that make the coordinates at s = 0, and of those that
    /// make the rays' directions; in any cell of the batch.
    Real size[3], direction_size[3];
};

/// Beam forms (engine/num/beam.hpp) of f over `size` cells, |u - u_i| <= u_radius,
/// |v - v_i| <= v_radius, |s - s_i| <= s_radius_i:
///   f is in c + k[0] eu + k[1] ev + k[2] et + [-e, e]  for eu, ev, et in [-1, 1].
/// Where f is not continuous, that may be of another function, which vanishes wherever f does.
/// Where nothing is known, c and k are 0 and e is +inf.
template <class Real>
struct FormBatchOf {
    std::size_t size;  ///< a multiple of Kernel::lane_multiple, not 0
    const Real* u;
    const Real* v;
    const Real* s;
    const Real* s_radius;
    const Real* frustum;   ///< a FrustumOf<Real>
    const Real* uniforms;  ///< Uniforms::boxes
    Real* c;
    Real* k[3];
    Real* e;
    /// out: an evaluation of f by the value kernel at a point of the cell, its coordinates those of
    /// a RaysOf, is off by less than u r, where each operation is off by less than u times its
    /// result
    Real* r;
    Real* slope_neg_lo;  ///< out: -lo of an enclosure of df/ds where f is continuous; +inf: unknown
    Real* slope_hi;
    ContinuityMask<Real>* continuous;  ///< out: as in RangeBatchOf
    ContinuityMask<Real>* nowhere;     ///< out: all ones where f is undefined in the whole cell
    HeldSwitches<Real> held = {};      ///< as in RangeBatchOf
    ContinuityMask<Real>* branches = nullptr;
    /// out of Kernel::ray_form, if Kernel::switches: where along the ray, in et, the first switch
    /// that is not decided may change; +inf and -inf: not known. A guess, nothing rests on it.
    /// nullptr: not asked for
    Real* cut_from = nullptr;
    Real* cut_to = nullptr;
};

/// The rays of a tile's pixels: the point at depth s on the ray of the pixel (col, row), counted
/// from the middle of the tile, is o + s d,
///   o = origin + col origin_by_col + row origin_by_row, and d likewise.
/// Rounded to nearest: FormBatchOf::r counts on it. Only numbers: kernels take it as an array.
template <class Real>
struct RaysOf {
    Real origin[3], origin_by_col[3], origin_by_row[3];
    Real direction[3], direction_by_col[3], direction_by_row[3];
};

/// Newton's method on the rays of `size` pixels.
template <class Real>
struct NewtonBatchOf {
    std::size_t size;  ///< a multiple of Kernel::lane_multiple, not 0
    const float* col;  ///< of the pixels, from the middle of the tile
    const float* row;
    const Real* from;  ///< where on the rays roots are looked for
    const Real* to;
    const Real* rays;      ///< a RaysOf<Real>
    const Real* uniforms;  ///< Uniforms::points
    /// After a step no longer than this on all rays of a vector there is no further one.
    Real small_step;
    int more_steps;  ///< at most, after the first; at least 0
    Real* s;  ///< in: guesses; out: where the steps end, in [from, to] where that is not empty
    Real* gradient[3];  ///< out: df/dx, df/dy, df/dz one step before s
    Real* per_slope;    ///< out: 1 / (df/ds) there
};

/// f on the rays of `size` pixels, in double, after some steps of Newton's method.
struct RayValueBatch {
    std::size_t size;  ///< a multiple of Kernel::lane_multiple, not 0
    const float* col;  ///< of the pixels, from the middle of the tile
    const float* row;
    const float* per_slope;  ///< 1 / (df/ds) near s
    int steps;               ///< at least 0
    double lo, hi;           ///< steps end between these; lo where they would be NaN
    double* s;               ///< in and out
    const double* rays;      ///< a RaysOf<double>
    const double* uniforms;  ///< Uniforms::points
    double* f;               ///< out: at s, not rounded outward; see FormBatchOf::r
};

using RangeBatch = RangeBatchOf<float>;
using ValueBatch = ValueBatchOf<float>;
using FormBatch = FormBatchOf<float>;

}  // namespace zeroset
