#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace zeroset {

/// Batches hold a multiple of this many items, whatever the lanes of the code that runs them.
inline constexpr std::size_t batch_multiple = 16;

/// w and the parameters, the same for a whole batch. Item 0 is w. An interval [lo, hi] is stored
/// as (-lo, hi), like every interval in this project.
struct Uniforms {
    std::vector<float> neg_lo_hi;  ///< -lo, hi of item 0, -lo, hi of item 1, ...
    std::vector<float> middle;     ///< one value for each item, for point evaluation

    /// The item's enclosure becomes the floats around [lo, hi].
    void set(std::size_t item, double lo, double hi);
    void set(std::size_t item, double value) { set(item, value, value); }
};

/// `size` boxes in x, y, z; arrays of `size` floats, in structure-of-arrays form.
struct RangeBatch {
    std::size_t size;           ///< a multiple of batch_multiple, not 0
    const float* neg_lo[3];     ///< -lo of x, y, z
    const float* hi[3];         ///< hi of x, y, z
    const float* uniforms;      ///< Uniforms::neg_lo_hi
    float* f_neg_lo;            ///< out: -lo of an enclosure of f over the box; -inf: f undefined
    float* f_hi;                ///< out: hi of it; -inf: f undefined in the whole box
    std::uint32_t* continuous;  ///< out: all ones where f is proved defined and continuous, else 0
};

/// `size` points.
struct ValueBatch {
    std::size_t size;       ///< a multiple of batch_multiple, not 0
    const float* x[3];      ///< x, y, z
    const float* uniforms;  ///< Uniforms::middle
    float* f;               ///< out: f, not rounded outward
    float* gradient[3];     ///< out: df/dx, df/dy, df/dz
};

/// What the tracer asks of a formula, whoever made the code (jit/compile or
/// engine/expr/interpret). A value, cheap to copy; safe to call from any number of threads.
/// Calls are made in upward rounding (engine/num/rounding.hpp), or the enclosures do not hold.
struct Kernel {
    using RangeFunction = void (*)(const void* code, const RangeBatch* batch);
    using ValueFunction = void (*)(const void* code, const ValueBatch* batch);

    RangeFunction range_function = nullptr;
    ValueFunction value_function = nullptr;
    std::shared_ptr<const void> code;     ///< keeps the machine code or the graph alive
    std::vector<std::string> parameters;  ///< names of the uniforms after w
    bool uses_w = false;

    void range(const RangeBatch& batch) const { range_function(code.get(), &batch); }
    void value(const ValueBatch& batch) const { value_function(code.get(), &batch); }
    explicit operator bool() const { return range_function != nullptr; }
};

}  // namespace zeroset
