#include "engine/kernel/float_check.hpp"

#include "engine/kernel/range_boxes.hpp"
#include "engine/real/rounding.hpp"
#include "engine/real/scalar.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace zeroset {
namespace {

constexpr std::size_t boxes = 64;
static_assert(boxes % batch_multiple == 0);
/// Edges of the boxes asked for, as a part of the whole box's.
constexpr double box_edge = 0x1p-10;
/// Where doubles tell that f is not 0 and floats do not, in so many boxes, floats do not suffice.
constexpr std::size_t most_untold = boxes / 16;

/// Points spread evenly in the unit cube [Roberts18].
std::array<double, 3> place(std::size_t i) {
    constexpr std::array steps{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
    std::array<double, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double x = 0.5 + static_cast<double>(i) * steps[k];
        at[k] = x - std::floor(x);
    }
    return at;
}

/// Where |f| is above this in all boxes, or below its inverse in a quarter of them, floats leave
/// their range in what is made of f: slopes, products and squares of these.
constexpr double extreme = 1e30;

/// Lower bounds of |f| in boxes, by ranges of this type; 0 where f may have a zero, +inf where it
/// is not defined.
template <class Real>
std::array<double, boxes> distances_from_zero(const KernelFunction<RangeBatchOf<Real>>& range,
                                              const std::array<double, 3>& lo,
                                              const std::array<double, 3>& hi,
                                              const Uniforms& uniforms) {
    RangeBoxes<Real, boxes> cells;
    for (std::size_t i = 0; i < boxes; ++i) {
        const std::array<double, 3> at = place(i);
        for (std::size_t k = 0; k < 3; ++k) {
            const double edge = hi[k] - lo[k];
            const double begin = lo[k] + (1.0 - box_edge) * edge * at[k];
            cells.ends[k][i] = upper_end(Real{}, -begin);
            cells.ends[k + 3][i] = upper_end(Real{}, begin + box_edge * edge);
        }
    }
    range(cells.batch(boxes, uniforms.boxes<Real>()));
    std::array<double, boxes> result{};
    for (std::size_t i = 0; i < boxes; ++i) {
        const Real least = cells.least_size(i);
        if (least > Real{0}) result[i] = static_cast<double>(least);
    }
    return result;
}

bool are_extreme(std::array<double, boxes> distances) {
    constexpr double undefined = std::numeric_limits<double>::infinity();
    std::ranges::sort(distances);
    const std::span told(std::ranges::upper_bound(distances, 0.0),
                         std::ranges::lower_bound(distances, undefined));
    if (told.empty()) return false;
    return told.front() > extreme || told[told.size() / 4] < 1.0 / extreme;
}

}  // namespace

FloatCheck::FloatCheck(const Kernel& ranges)
    : in_float_(ranges.in_float.range), in_double_(ranges.in_double.range) {}

bool FloatCheck::measured(const std::array<double, 3>& lo, const std::array<double, 3>& hi,
                          const Uniforms& uniforms) const {
    const UpwardRounding upward;
    const auto by_float = distances_from_zero(in_float_, lo, hi, uniforms);
    const auto by_double = distances_from_zero(in_double_, lo, hi, uniforms);
    std::size_t untold = 0;
    for (std::size_t i = 0; i < boxes; ++i)
        untold += by_double[i] > 0.0 && !(by_float[i] > 0.0) ? 1U : 0U;
    return untold <= most_untold && !are_extreme(by_double);
}

bool FloatCheck::suffices(const std::array<double, 3>& lo, const std::array<double, 3>& hi,
                          const Uniforms& uniforms) const {
    const std::scoped_lock lock(mutex_);
    if (known_ && lo_ == lo && hi_ == hi && uniforms_ == uniforms.neg_lo_hi_double)
        return suffices_;
    lo_ = lo;
    hi_ = hi;
    uniforms_ = uniforms.neg_lo_hi_double;
    known_ = true;
    return suffices_ = measured(lo, hi, uniforms);
}

}  // namespace zeroset
