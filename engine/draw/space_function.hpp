#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/rewrite/sample/box_sample.hpp"
#include "engine/view/box.hpp"

#include <glm/glm.hpp>

#include <array>
#include <functional>
#include <span>

namespace zeroset {

/// The values that a function may have in a box.
struct Bounds {
    double lo, hi;               ///< infinite where nothing is known
    bool excludes_zero = false;  ///< the function is surely nowhere 0, or nowhere defined
    bool continuous = false;     ///< it surely is, and defined, in all of the box
};

/// A function over a box: within `error` of value + dot(gradient, p - centre), or of another
/// function that is 0 wherever it is.
struct LinearBounds {
    double value, error;  ///< error is infinite where nothing is known
    glm::dvec3 gradient;
    bool nowhere = false;  ///< the function is undefined in all of the box
};

/// A function's value and gradient at a point.
struct ValueAndGradient {
    double value;
    glm::dvec3 gradient;
};

/// Makes the code of a formula, of which values, ranges and forms in double are called.
using KernelMaker = std::function<Kernel(const Expr&)>;

/// A function of space with its derivatives: values at points, and enclosures over boxes, in
/// double. Any thread, in whatever rounding.
class SpaceFunction {
public:
    /// `uniforms` lives longer. The derivatives are written so that they are enclosed tightly in
    /// `box`, which takes some milliseconds for a polynomial.
    SpaceFunction(const Expr& f, const Uniforms& uniforms, const Box& box,
                  const KernelMaker& make_kernel);

    /// Whether it has jumps, of which its derivatives tell nothing.
    [[nodiscard]] bool may_jump() const { return kernel_.switches > 0; }
    [[nodiscard]] ValueAndGradient at(const glm::dvec3& point) const;
    void enclose(std::span<const Box> boxes, std::span<Bounds> out) const;
    /// Encloses the function by linear ones over boxes of one size, none of them flat.
    void enclose_linear(std::span<const Box> boxes, std::span<LinearBounds> out) const;
    /// Encloses one of the derivatives.
    void enclose_slope(std::size_t axis, std::span<const Box> boxes, std::span<Bounds> out) const;

private:
    Kernel kernel_;
    std::array<Kernel, 3> slopes_;
    const Uniforms* uniforms_;
};

/// The box as the region in which formulas are to be tight.
SampleRegion sample_region_of(const Box& box);

/// The value of a function at a point, or its gradient, too, by kernels in double; in whatever
/// rounding.
ValueAndGradient value_at(const Kernel& kernel, const Uniforms& uniforms, const glm::dvec3& point);

}  // namespace zeroset
