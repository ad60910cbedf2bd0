#pragma once

#include "engine/rewrite/sample/box_sample.hpp"
#include "engine/view/box.hpp"

#include <cstddef>

namespace zeroset {

/// Converts the box to the region in which a formula is going to be evaluated.
inline SampleRegion sample_region(const Box& box) {
    SampleRegion region;
    for (int i = 0; i < 3; ++i) {
        region.lo[static_cast<std::size_t>(i)] = box.lo[i];
        region.hi[static_cast<std::size_t>(i)] = box.hi[i];
    }
    return region;
}

}  // namespace zeroset
