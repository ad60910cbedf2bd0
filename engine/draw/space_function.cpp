#include "engine/draw/space_function.hpp"

#include "engine/kernel/form_cells.hpp"
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
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        out[i] = bounds_of(batch.f_neg_lo[i], batch.f_hi[i]);
        out[i].continuous = batch.continuous[i] != 0;
    }
}

void enclose_all(const Kernel& kernel, const Uniforms& uniforms, std::span<const Box> boxes,
                 std::span<Bounds> out) {
    for (std::size_t first = 0; first < boxes.size(); first += at_once) {
        const std::size_t count = std::min(at_once, boxes.size() - first);
        enclose_some(kernel, uniforms, boxes.subspan(first, count), out.subspan(first, count));
    }
}

[[gnu::noinline]] void call_form(const Kernel& kernel, const FormBatchOf<double>& batch) {
    const UpwardRegisters upward;
    kernel.in_double.form(batch);
}

/// Boxes of one size as cells of a frustum whose rays are nearly parallel, along z: from an eye so
/// far away that the cells are wider than the boxes by less than `widening`.
class BoxFrustum {
public:
    explicit BoxFrustum(std::span<const Box> boxes) : boxes_(boxes), base_(boxes[0].centre()) {
        glm::dvec3 extent(0.0);
        for (const Box& box : boxes) {
            half_ = glm::max(half_, 0.5 * (box.hi - box.lo));
            extent = glm::max(extent, glm::abs(box.centre() - base_));
        }
        const double widest = std::max({half_.x, half_.y, half_.z});
        distance_ = 0x1p20 * (std::max({extent.x, extent.y, extent.z}) + widest);
        half_ = (half_ + 0x1p-19 * widest) * (1.0 + widening);
        frustum_ = {.base = {base_.x, base_.y, base_.z},
                    .right = {1.0, 0.0, 0.0},
                    .up = {0.0, 1.0, 0.0},
                    .forward = {0.0, 0.0, 1.0},
                    .distance = distance_,
                    .u_radius = half_.x / distance_,
                    .v_radius = half_.y / distance_,
                    .size = {},
                    .direction_size = {2.0, 2.0, 2.0}};
        for (int i = 0; i < 3; ++i)
            frustum_.size[i] = 2.0 * (std::abs(base_[i]) + extent[i] + half_[i]);
    }

    void set(FormCells<double, at_once>& cells) const {
        for (std::size_t i = 0; i < padded(boxes_.size()); ++i) {
            const glm::dvec3 off = boxes_[std::min(i, boxes_.size() - 1)].centre() - base_;
            cells.u[i] = off.x / (distance_ + off.z);
            cells.v[i] = off.y / (distance_ + off.z);
            cells.s[i] = off.z;
            cells.s_radius[i] = half_.z;
        }
    }
    [[nodiscard]] const FrustumOf<double>& frustum() const { return frustum_; }
    /// Half the cells' edges.
    [[nodiscard]] const glm::dvec3& half() const { return half_; }

private:
    static constexpr double widening = 0x1p-18;

    std::span<const Box> boxes_;
    glm::dvec3 base_;
    glm::dvec3 half_{0.0};
    double distance_ = 0.0;
    FrustumOf<double> frustum_{};
};

void enclose_some_linear(const Kernel& kernel, const Uniforms& uniforms, std::span<const Box> boxes,
                         std::span<LinearBounds> out) {
    const BoxFrustum frustum(boxes);
    FormCells<double, at_once> cells;
    frustum.set(cells);
    call_form(kernel,
              cells.batch(padded(boxes.size()), frustum.frustum(), uniforms.boxes<double>()));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const glm::dvec3 change(cells.k[0][i], cells.k[1][i], cells.k[2][i]);
        out[i] = {.value = cells.c[i],
                  .error = cells.e[i],
                  .gradient = change / frustum.half(),
                  .nowhere = cells.nowhere[i] != 0};
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

SpaceFunction::SpaceFunction(const Expr& f, const Uniforms& uniforms, const Box& box,
                             const KernelMaker& make_kernel)
    : kernel_(make_kernel(f)), uniforms_(&uniforms) {
    const SampleRegion region = sample_region_of(box);
    const std::array<Expr, 3> slopes = gradient_of(f);
    for (std::size_t i = 0; i < 3; ++i)
        slopes_.at(i) = make_kernel(tightened(slopes.at(i), region));
}

ValueAndGradient SpaceFunction::at(const glm::dvec3& point) const {
    return value_at(kernel_, *uniforms_, point);
}

void SpaceFunction::enclose(std::span<const Box> boxes, std::span<Bounds> out) const {
    enclose_all(kernel_, *uniforms_, boxes, out);
}

void SpaceFunction::enclose_linear(std::span<const Box> boxes, std::span<LinearBounds> out) const {
    for (std::size_t first = 0; first < boxes.size(); first += at_once) {
        const std::size_t count = std::min(at_once, boxes.size() - first);
        enclose_some_linear(kernel_, *uniforms_, boxes.subspan(first, count),
                            out.subspan(first, count));
    }
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
