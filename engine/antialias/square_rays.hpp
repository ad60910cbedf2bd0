#pragma once

#include <array>
#include <cstddef>

namespace zeroset {

/// The rays that stand for a square: through its middle, and through the middles of its quarters.
/// In halves of its side from its middle, to the right and downwards.
struct SquareRay {
    double x, y;
};
inline constexpr std::size_t square_ray_count = 5;
inline constexpr std::array<SquareRay, square_ray_count> square_rays{{{.x = 0.0, .y = 0.0},
                                                                      {.x = -0.5, .y = -0.5},
                                                                      {.x = 0.5, .y = -0.5},
                                                                      {.x = -0.5, .y = 0.5},
                                                                      {.x = 0.5, .y = 0.5}}};

/// Something that is so of each of these rays, or not.
using SquareRayFlags = std::array<bool, square_ray_count>;

inline constexpr SquareRay square_middle{.x = 0.0, .y = 0.0};
inline constexpr std::array<SquareRay, 4> square_corners{
    {{.x = -1.0, .y = -1.0}, {.x = 1.0, .y = -1.0}, {.x = -1.0, .y = 1.0}, {.x = 1.0, .y = 1.0}}};

}  // namespace zeroset
