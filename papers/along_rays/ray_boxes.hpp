#pragma once

#include <array>
#include <cstddef>

namespace zeroset {

/// Stretches of rays: the points origin + s direction for s between `from` and `to`. Arrays of a
/// fixed capacity, a multiple of 8.
template <std::size_t capacity>
struct RaySpans {
    static_assert(capacity % 8 == 0);
    std::array<double, capacity> from{}, to{};
    std::array<std::array<double, capacity>, 3> origin{}, direction{};
};

/// RaySpans as plain arrays.
struct RaySpanArrays {
    const double* from;
    const double* to;
    std::array<const double*, 3> origin, direction;
};

/// Boxes about the first `count` stretches: -lo of x, y, z, then hi of x, y, z. They hold the
/// points of the line that these numbers are, to the last bit: a ray up to shifts as in TileHits.
/// Reads and writes up to a multiple of 8. In upward rounding.
void make_ray_boxes(const RaySpanArrays& spans, std::size_t count,
                    const std::array<float*, 6>& ends);
void make_ray_boxes(const RaySpanArrays& spans, std::size_t count,
                    const std::array<double*, 6>& ends);

}  // namespace zeroset
