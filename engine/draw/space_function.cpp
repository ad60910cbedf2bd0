#include "engine/draw/space_function.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/real/rounding.hpp"
#include "engine/rewrite/differences/derivatives.hpp"
#include "engine/rewrite/polynomial/tighten.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace zeroset {
namespace {

constexpr std::size_t at_once = 256;

Bounds bounds_of(double neg_lo, double hi) {
    constexpr double all = std::numeric_limits<double>::infinity();
    const bool excludes = neg_lo < 0.0 || hi < 0.0;
    if (-neg_lo <= hi) return {.lo = -neg_lo, .hi = hi, .excludes_zero = excludes};
    return {.lo = -all, .hi = all, .excludes_zero = excludes};
}

/// Calls the kernel in upward rounding, which must not be left to the caller's optimizer.
[[gnu::noinline]] void call_range(const Kernel& kernel, const RangeBatchOf<double>& batch) {
    const UpwardRegisters upward;
    kernel.in_double.range(batch);
}

[[gnu::noinline]] void call_value(const Kernel& kernel, const ValueBatchOf<double>& batch) {
    const UpwardRegisters upward;
    kernel.in_double.value(batch);
}

void enclose_some(const Kernel& kernel, const Uniforms& uniforms, std::span<const Box> boxes,
                  std::span<Bounds> out) {
    RangeBoxes<double, at_once> batch;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            batch.ends[axis][i] = -boxes[i].lo[axis];
            batch.ends[axis + 3][i] = boxes[i].hi[axis];
        }
    }
    batch.pad(boxes.size());
    call_range(kernel, batch.batch(padded(boxes.size()), uniforms.boxes<double>()));
    for (std::size_t i = 0; i < boxes.size(); ++i)
        out[i] = bounds_of(batch.f_neg_lo[i], batch.f_hi[i]);
}

void enclose_all(const Kernel& kernel, const Uniforms& uniforms, std::span<const Box> boxes,
                 std::span<Bounds> out) {
    for (std::size_t first = 0; first < boxes.size(); first += at_once) {
        const std::size_t count = std::min(at_once, boxes.size() - first);
        enclose_some(kernel, uniforms, boxes.subspan(first, count), out.subspan(first, count));
    }
}

}  // namespace

SampleRegion sample_region_of(const Box& box) {
    SampleRegion region;
    for (int axis = 0; axis < 3; ++axis) {
        region.lo.at(static_cast<std::size_t>(axis)) = box.lo[axis];
        region.hi.at(static_cast<std::size_t>(axis)) = box.hi[axis];
    }
    return region;
}

SpaceFunction::SpaceFunction(const Expr& f, const Uniforms& uniforms, const Box& box)
    : kernel_(interpret(f)), uniforms_(&uniforms) {
    const SampleRegion region = sample_region_of(box);
    const std::array<Expr, 3> slopes = gradient_of(f);
    for (std::size_t i = 0; i < 3; ++i)
        slopes_.at(i) = interpret(tightened(slopes.at(i), region));
}

ValueAndGradient SpaceFunction::at(const glm::dvec3& point) const {
    return value_at(kernel_, *uniforms_, point);
}

void SpaceFunction::enclose(std::span<const Box> boxes, std::span<Bounds> out) const {
    enclose_all(kernel_, *uniforms_, boxes, out);
}

void SpaceFunction::enclose_slope(std::size_t axis, std::span<const Box> boxes,
                                  std::span<Bounds> out) const {
    enclose_all(slopes_.at(axis), *uniforms_, boxes, out);
}

ValueAndGradient value_at(const Kernel& kernel, const Uniforms& uniforms, const glm::dvec3& point) {
    alignas(64) std::array<std::array<double, batch_multiple>, 7> columns;
    for (int axis = 0; axis < 3; ++axis)
        columns.at(static_cast<std::size_t>(axis)).fill(point[axis]);
    call_value(kernel, {.size = batch_multiple,
                        .x = {columns[0].data(), columns[1].data(), columns[2].data()},
                        .uniforms = uniforms.points<double>(),
                        .f = columns[3].data(),
                        .gradient = {columns[4].data(), columns[5].data(), columns[6].data()}});
    return {.value = columns[3][0], .gradient = {columns[4][0], columns[5][0], columns[6][0]}};
}

}  // namespace zeroset
