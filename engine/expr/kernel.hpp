#pragma once

#include "engine/num/rounding.hpp"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
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
        if constexpr (std::is_same_v<Real, float>) {
            return neg_lo_hi.data();
        } else {
            return neg_lo_hi_double.data();
        }
    }
    template <class Real>
    [[nodiscard]] const Real* points() const {
        if constexpr (std::is_same_v<Real, float>) {
            return middle.data();
        } else {
            return middle_double.data();
        }
    }
};

/// What tells of each box whether f is continuous there: as wide as the numbers beside it.
template <class Real>
using ContinuityMask = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

/// `size` boxes in x, y, z; arrays of `size` numbers, in structure-of-arrays form.
template <class Real>
struct RangeBatchOf {
    std::size_t size;       ///< a multiple of batch_multiple, not 0
    const Real* neg_lo[3];  ///< -lo of x, y, z: of whatever boxes (engine/num/interval.hpp)
    const Real* hi[3];      ///< hi of x, y, z
    const Real* uniforms;   ///< Uniforms::boxes
    Real* f_neg_lo;         ///< out: -lo of an enclosure of f over the box; -inf: f undefined
    Real* f_hi;             ///< out: hi of it; -inf: f undefined in the whole box; NaN: unknown
    /// out: all ones where f is proved defined and continuous, else 0
    ContinuityMask<Real>* continuous;
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

using RangeBatch = RangeBatchOf<float>;
using ValueBatch = ValueBatchOf<float>;

/// What the tracer asks of a formula, whoever made the code (jit/compile or
/// engine/expr/interpret). A value, cheap to copy; safe to call from any number of threads.
/// Calls are made in upward rounding (engine/num/rounding.hpp), or the enclosures do not hold.
struct Kernel {
    template <class Real>
    using RangeFunctionOf = void (*)(const void* code, const RangeBatchOf<Real>* batch);
    template <class Real>
    using ValueFunctionOf = void (*)(const void* code, const ValueBatchOf<Real>* batch);
    using RangeFunction = RangeFunctionOf<float>;
    using ValueFunction = ValueFunctionOf<float>;

    RangeFunction range_function = nullptr;
    ValueFunction value_function = nullptr;
    std::shared_ptr<const void> code;  ///< keeps the machine code or the graph alive
    RangeFunctionOf<double> range_function_double = nullptr;
    ValueFunctionOf<double> value_function_double = nullptr;
    std::shared_ptr<const void> code_double;
    std::vector<std::string> parameters;  ///< names of the uniforms after w
    bool uses_w = false;

    void range(const RangeBatch& batch) const {
        assert(rounds_upward());
        range_function(code.get(), &batch);
    }
    void value(const ValueBatch& batch) const {
        assert(rounds_upward());
        value_function(code.get(), &batch);
    }
    explicit operator bool() const { return range_function != nullptr; }

    // Only where the maker was asked for double.
    void range(const RangeBatchOf<double>& batch) const {
        assert(rounds_upward());
        range_function_double(code_double.get(), &batch);
    }
    void value(const ValueBatchOf<double>& batch) const {
        assert(rounds_upward());
        value_function_double(code_double.get(), &batch);
    }
    [[nodiscard]] bool has_double() const { return range_function_double != nullptr; }
};

}  // namespace zeroset
