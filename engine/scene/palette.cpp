#include "engine/scene/palette.hpp"

#include "engine/image/gamma.hpp"

#include <array>

namespace zeroset {
namespace {

// Fronts are far apart from each other, also where red and green look alike, and backs, paler or
// deeper tones of the same hue, from their fronts (palette_test).
constexpr std::array<SurfaceColors, 8> pairs{{
    {.front = {0.1F, 0.32F, 0.72F}, .back = {0.55F, 0.73F, 0.96F}},     // blue
    {.front = {0.007F, 0.44F, 0.155F}, .back = {0.55F, 0.97F, 0.69F}},  // green
    {.front = {0.886F, 0.758F, 0.11F}, .back = {0.95F, 0.88F, 0.52F}},  // yellow
    {.front = {0.63F, 0.096F, 0.03F}, .back = {0.93F, 0.43F, 0.36F}},   // vermilion
    {.front = {0.31F, 0.09F, 0.374F}, .back = {0.85F, 0.46F, 0.97F}},   // purple
    {.front = {0.7F, 0.76F, 0.84F}, .back = {0.19F, 0.22F, 0.27F}},     // silver
    {.front = {0.06F, 0.122F, 0.15F}, .back = {0.36F, 0.66F, 0.8F}},    // slate
    {.front = {0.84F, 0.328F, 0.44F}, .back = {0.2F, 0.05F, 0.09F}},    // rose
}};

}  // namespace

std::span<const SurfaceColors> palette() { return pairs; }

const SurfaceColors& colors_of(std::size_t surface) { return pairs[surface % pairs.size()]; }

std::uint32_t swatch_color(const float (&side)[3]) {
    return 0xFF000000U | channel_of_light(side[2]) << 16U | channel_of_light(side[1]) << 8U |
           channel_of_light(side[0]);
}

std::uint32_t swatch_color(std::size_t surface) { return swatch_color(colors_of(surface).front); }

}  // namespace zeroset
