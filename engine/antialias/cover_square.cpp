#include "engine/antialias/cover_square.hpp"

#include <cstddef>

namespace zeroset {

SquareRay SquareRest::middle() const {
    if (part.share > 0.0) return {.x = part.x, .y = part.y};
    SquareRay sum{.x = 0.0, .y = 0.0};
    double count = 0.0;
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        if (!misses[i]) continue;
        sum.x += square_rays[i].x;
        sum.y += square_rays[i].y;
        count += 1.0;
    }
    return count > 0.0 ? SquareRay{.x = sum.x / count, .y = sum.y / count} : square_middle;
}

}  // namespace zeroset
