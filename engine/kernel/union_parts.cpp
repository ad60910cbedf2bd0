#include "engine/kernel/union_parts.hpp"

#include "engine/kernel/range_boxes.hpp"
#include "engine/real/rounding.hpp"

#include <algorithm>
#include <cstddef>

namespace zeroset {
namespace {

constexpr std::size_t slices = batch_multiple;

/// Slices of a box across an axis, and what f is over them: equal ones, or thin ones at both ends.
class Slices {
public:
    Slices(const ReachBox& box, std::size_t axis, bool thin_at_ends) {
        for (std::size_t k = 0; k < 3; ++k) {
            std::ranges::fill(boxes_.ends[k], -box.lo[k]);
            std::ranges::fill(boxes_.ends[k + 3], box.hi[k]);
        }
        const float lo = box.lo[axis];
        const float hi = box.hi[axis];
        for (std::size_t i = 1; i < slices; ++i) {
            const float part = end_of(i - 1, thin_at_ends);
            const float end = std::clamp(lo + (hi - lo) * part, lo, hi);
            boxes_.ends[axis + 3][i - 1] = end;
            boxes_.ends[axis][i] = -end;
        }
    }
    void evaluate(const Kernel& kernel, const float* uniforms) {
        kernel.range(boxes_.batch(slices, uniforms));
    }
    [[nodiscard]] bool above_zero(std::size_t i) const {
        return boxes_.f_neg_lo[i] < 0 && !(boxes_.f_hi[i] < 0) && continuous(i);
    }
    [[nodiscard]] bool continuous(std::size_t i) const { return boxes_.continuous[i] != 0; }
    [[nodiscard]] float lo(std::size_t axis, std::size_t i) const { return -boxes_.ends[axis][i]; }
    [[nodiscard]] float hi(std::size_t axis, std::size_t i) const {
        return boxes_.ends[axis + 3][i];
    }

private:
    /// Where slice i ends, as a part of the box's width.
    static float end_of(std::size_t i, bool thin_at_ends) {
        constexpr std::size_t thin = slices / 2 - 1;
        constexpr float step = 0.125F / thin;
        if (!thin_at_ends) return static_cast<float>(i + 1) / slices;
        if (i < thin) return step * static_cast<float>(i + 1);
        if (i == thin) return 0.5F;
        return 1.0F - step * static_cast<float>(slices - 1 - i);
    }

    RangeBoxes<float, slices> boxes_;
};

/// Takes away the slices at both ends where f is above 0; returns how much of the box is left.
float trim(Reach& reach, std::size_t axis, bool thin_at_ends, const Kernel& kernel,
           const float* uniforms) {
    Slices parts(reach.box, axis, thin_at_ends);
    parts.evaluate(kernel, uniforms);
    std::size_t first = 0;
    std::size_t last = slices;
    while (first < last && parts.above_zero(first))
        ++first;
    while (first < last && parts.above_zero(last - 1))
        --last;
    reach.any = first < last;
    if (!reach.any) return 0;
    reach.continuous = true;
    for (std::size_t i = first; i < last; ++i)
        reach.continuous = reach.continuous && parts.continuous(i);
    reach.box.lo[axis] = parts.lo(axis, first);
    reach.box.hi[axis] = parts.hi(axis, last - 1);
    return thin_at_ends ? 1.0F : static_cast<float>(last - first) / slices;
}

/// Whether f is above 0 in what the box has of the layers under the domain's faces.
bool is_above_zero_at_faces(const Kernel& kernel, const ReachBox& box, const ReachBox& domain,
                            const float* uniforms) {
    float longest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        longest = std::max(longest, domain.hi[axis] - domain.lo[axis]);
    const auto is_above_zero = [&](std::size_t axis, float from, float to) {
        if (box.lo[axis] > to || box.hi[axis] < from) return true;
        ReachBox layer = box;
        layer.lo[axis] = from;
        layer.hi[axis] = to;
        Slices parts(layer, (axis + 1) % 3, false);
        parts.evaluate(kernel, uniforms);
        bool all = true;
        for (std::size_t i = 0; i < slices; ++i)
            all = all && parts.above_zero(i);
        return all;
    };
    const float thick = static_cast<float>(face_layer) * longest;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float lo_end = domain.lo[axis] + thick;
        const float hi_begin = -(thick - domain.hi[axis]);
        if (!is_above_zero(axis, domain.lo[axis], lo_end)) return false;
        if (!is_above_zero(axis, hi_begin, domain.hi[axis])) return false;
    }
    return true;
}

}  // namespace

Reach reach_of(const Kernel& kernel, const ReachBox& domain, const float* uniforms) {
    constexpr int most_rounds = 5;
    constexpr float small_gain = 0.8F;
    Reach reach{.any = true, .box = domain};
    const auto go_round = [&](bool thin_at_ends) {
        float left = 1;
        for (std::size_t axis = 0; axis < 3 && reach.any; ++axis)
            left *= trim(reach, axis, thin_at_ends, kernel, uniforms);
        return left;
    };
    for (int round = 0; round < most_rounds && reach.any; ++round) {
        if (go_round(false) > small_gain) break;
    }
    if (reach.any) go_round(true);
    reach.within = !reach.any || is_above_zero_at_faces(kernel, reach.box, domain, uniforms);
    return reach;
}

std::shared_ptr<const std::vector<Reach>> UnionParts::reaches(const ReachBox& domain,
                                                              const Uniforms& uniforms) const {
    const std::scoped_lock lock(mutex_);
    if (reaches_ && domain_ == domain && uniforms_ == uniforms.neg_lo_hi) return reaches_;
    const UpwardRounding upward;
    auto made = std::make_shared<std::vector<Reach>>();
    for (const Kernel* kernel : kernels_)
        made->push_back(reach_of(*kernel, domain, uniforms.boxes<float>()));
    domain_ = domain;
    uniforms_ = uniforms.neg_lo_hi;
    return reaches_ = std::move(made);
}

}  // namespace zeroset
