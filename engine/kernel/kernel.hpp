#pragma once

#include "engine/real/rounding.hpp"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace zeroset {

/// Batches hold a multiple of this many items, whatever the lanes of the code that runs them.
inline constexpr std::size_t batch_multiple = 16;

/// w and the parameters, the same for a whole batch. Item 0 is w. An interval [lo, hi] is stored
/// as (-lo, hi), like every interval in this project. For kernels in float and in double.
struct Uniforms {
    std::vector<float> neg_lo_hi;  ///< -lo, hi of item 0, -lo, hi of item 1, ...
    std::vector<float> middle;     ///< one value for each item, for point evaluation
    std::vector<double> neg_lo_hi_double;
    std::vector<double> middle_double;

    /// The item's enclosures become [lo, hi] in double and the floats around it: NaN is unknown, an
    /// end beyond all numbers the largest of them and all above.
    void set(std::size_t item, double lo, double hi);
    void set(std::size_t item, double value) { set(item, value, value); }

    /// What batches in this type take as `uniforms`: over boxes and over points.
    template <class Real>
    [[nodiscard]] const Real* boxes() const {
        return all_boxes<Real>().data();
    }
    template <class Real>
    [[nodiscard]] const Real* points() const {
        return all_points<Real>().data();
    }
    /// Two numbers an item, and one.
    template <class Real>
    [[nodiscard]] std::span<const Real> all_boxes() const {
        if constexpr (std::is_same_v<Real, float>) {
            return neg_lo_hi;
        } else {
            return neg_lo_hi_double;
        }
    }
    template <class Real>
    [[nodiscard]] std::span<const Real> all_points() const {
        if constexpr (std::is_same_v<Real, float>) {
            return middle;
        } else {
            return middle_double;
        }
    }
};

/// What tells of each box whether f is continuous there: as wide as the numbers beside it.
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

/// What a kernel says of branches in a box: whether it may hold a kink (of abs, min, max), and the
/// first switch that has more than one outcome there, at most three.
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

/// How a batch of cells lies in the world: the point at depth s on the ray of (u, v) is
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
    const Real* from;  ///< the stretches of the rays where roots are looked for
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

/// Code over batches of one kind, with what keeps it alive. Cheap to copy; safe to call from any
/// number of threads, in upward rounding (engine/real/rounding.hpp), or the enclosures do not hold.
template <class Batch>
struct KernelFunction {
    void (*call)(const void* code, const Batch* batch) = nullptr;
    std::shared_ptr<const void> code;
    /// The same without waiting for code that `call` makes first: slower code does its work.
    /// nullptr: `call` never waits.
    void (*meanwhile)(const void* code, const Batch* batch) = nullptr;

    void operator()(const Batch& batch) const {
        assert(rounds_upward());
        call(code.get(), &batch);
    }
    /// Of this function, or of what does its work meanwhile.
    [[nodiscard]] KernelFunction without_waiting() const {
        return {meanwhile != nullptr ? meanwhile : call, code};
    }
    explicit operator bool() const { return call != nullptr; }
    bool operator==(const KernelFunction&) const = default;
};

/// f in double at points; the batch's `gradient` is left alone.
using PointFunction = KernelFunction<ValueBatchOf<double>>;

/// For one choice (min, max, if, where) and a block of cells, a bit for each cell: the first
/// alternative surely may stand for the choice, or the second, in the whole cell: it is its value,
/// or does the same to signs and zeros of f; and the choice is defined wherever it is.
struct ChoiceBits {
    std::uint16_t first = 0;
    std::uint16_t second = 0;
};

/// How the choices of a formula fall in the cells of a batch.
struct ChoiceRecord {
    std::size_t lanes = 1;         ///< cells a block
    std::size_t choices = 0;       ///< of the formula
    std::vector<ChoiceBits> bits;  ///< of each block, of each choice
};

struct Kernel;
class FloatCheck;
class LeastOf;

/// Makes kernels that leave out what does not matter in a part of space, as other parts of a union
/// [Keeter20]. Thread-safe; called in upward rounding.
class Shortener {
public:
    virtual ~Shortener() = default;

    /// As Kernel::form of a function with f's signs and zeros; and how the choices fall.
    virtual void form(const FormBatchOf<float>& batch, ChoiceRecord& record) const = 0;
    virtual void form(const FormBatchOf<double>& batch, ChoiceRecord& record) const = 0;
    /// A kernel for the points of these cells of the recorded batch: there its function is defined
    /// where the whole one is, with the same signs and zeros, and beside the zeros the same one.
    /// nullptr where it would not be shorter. Without the names of parameters. A copy of it lives
    /// no longer than it.
    [[nodiscard]] virtual std::shared_ptr<const Kernel> shortened(
        const ChoiceRecord& record, std::span<const std::size_t> cells) const = 0;
    /// The functions of which the whole one is the least; nullptr where it is not known as that.
    [[nodiscard]] virtual const LeastOf* least_of() const { return nullptr; }
};

/// What the tracer asks of a formula, whoever made the code (jit/compile or
/// engine/expr/interpret).
struct Kernel {
    KernelFunction<RangeBatchOf<float>> range_float;
    KernelFunction<ValueBatchOf<float>> value_float;
    KernelFunction<FormBatchOf<float>> form_float;
    KernelFunction<FormBatchOf<float>> ray_form_float;  ///< of cells without width
    KernelFunction<NewtonBatchOf<float>> newton_float;
    KernelFunction<RayValueBatch> ray_value;
    // Slow (interpreted) but for the values, unless whole frames can be traced in double.
    KernelFunction<RangeBatchOf<double>> range_double;
    KernelFunction<ValueBatchOf<double>> value_double;
    KernelFunction<FormBatchOf<double>> form_double;
    KernelFunction<FormBatchOf<double>> ray_form_double;
    KernelFunction<NewtonBatchOf<double>> newton_double;
    /// Of the sizes of FormBatchOf, NewtonBatchOf and RayValueBatch; divides batch_multiple.
    std::size_t lane_multiple = batch_multiple;
    bool has_double = false;              ///< whether whole frames can be traced in double
    std::vector<std::string> parameters;  ///< names of the uniforms after w
    bool uses_w = false;
    std::size_t switches = 0;  ///< of HeldSwitches
    bool branches = false;     ///< whether BranchBits are ever but 0; else they are not written
    std::shared_ptr<const Shortener> shortener;  ///< nullptr where it would not pay
    bool interpreted = false;                    ///< else machine code
    std::size_t steps = 0;  ///< that the interpreter takes for an item; 0: machine code
    std::shared_ptr<const FloatCheck> float_check;  ///< nullptr: floats suffice
    /// Ranges of functions whose zeros are zeros of f (engine/rewrite/root_witnesses.hpp).
    std::vector<KernelFunction<RangeBatchOf<double>>> witnesses;
    bool defined_everywhere = false;  ///< for all values of the variables, surely
    /// Ranges of a function that is continuous only where f is defined; none: not known.
    KernelFunction<RangeBatchOf<double>> domain;

    void range(const RangeBatchOf<float>& batch) const { range_float(batch); }
    void range(const RangeBatchOf<double>& batch) const { range_double(batch); }
    void value(const ValueBatchOf<float>& batch) const { value_float(batch); }
    void value(const ValueBatchOf<double>& batch) const { value_double(batch); }
    void form(const FormBatchOf<float>& batch) const { form_float(batch); }
    void form(const FormBatchOf<double>& batch) const { form_double(batch); }
    /// As `form`; the frustum's radii are 0.
    void ray_form(const FormBatchOf<float>& batch) const { ray_form_float(batch); }
    void ray_form(const FormBatchOf<double>& batch) const { ray_form_double(batch); }
    void newton(const NewtonBatchOf<float>& batch) const { newton_float(batch); }
    void newton(const NewtonBatchOf<double>& batch) const { newton_double(batch); }
    explicit operator bool() const { return static_cast<bool>(range_float); }

    /// A kernel whose functions never wait for their code to be made.
    [[nodiscard]] Kernel without_waiting() const {
        Kernel kernel = *this;
        const auto change = [](auto&... functions) {
            ((functions = functions.without_waiting()), ...);
        };
        change(kernel.range_float, kernel.value_float, kernel.form_float, kernel.ray_form_float,
               kernel.newton_float, kernel.ray_value, kernel.range_double, kernel.value_double,
               kernel.form_double, kernel.ray_form_double, kernel.newton_double);
        return kernel;
    }
};

}  // namespace zeroset
