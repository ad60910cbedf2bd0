#include "engine/kernel/surface_facts.hpp"

#include "engine/kernel/range_boxes.hpp"

#include <algorithm>
#include <numeric>

namespace zeroset {

FieldLevel::Value FieldLevel::at(const Uniforms& uniforms) const {
    RangeBoxes<double, batch_multiple> boxes;
    for (auto& column : boxes.ends)
        column[0] = 0.0;
    boxes.pad(1);
    level(boxes.batch(batch_multiple, uniforms.boxes<double>()));
    const double lo = -boxes.f_neg_lo[0];
    const double hi = boxes.f_hi[0];
    const double middle = std::midpoint(lo, hi);
    return {.middle = middle, .error = std::max(hi - middle, middle - lo)};
}

const SurfaceFacts& surface_facts(const Kernel& kernel) {
    static const SurfaceFacts nothing;
    return kernel.facts == nullptr ? nothing : *kernel.facts;
}

}  // namespace zeroset
