#include "engine/scene/palette.hpp"

#include "engine/image/gamma.hpp"

#include <array>

namespace zeroset {
namespace {

// Fronts are far apart from each other, also where red and green look alike, and so are the sides
// of each pair (palette_test).
constexpr std::array<SurfaceColors, 8> pairs{{
    {.front = {0.10F, 0.32F, 0.72F}, .back = {0.82F, 0.36F, 0.06F}},      // blue, amber
    {.front = {0.007F, 0.44F, 0.155F}, .back = {0.61F, 0.264F, 0.60F}},   // green, lilac
    {.front = {0.886F, 0.758F, 0.11F}, .back = {0.13F, 0.09F, 0.434F}},   // yellow, violet
    {.front = {0.63F, 0.096F, 0.03F}, .back = {0.22F, 0.60F, 0.65F}},     // vermilion, pale cyan
    {.front = {0.31F, 0.09F, 0.374F}, .back = {0.41F, 0.62F, 0.125F}},    // purple, lime
    {.front = {0.70F, 0.76F, 0.84F}, .back = {0.19F, 0.14F, 0.116F}},     // silver, umber
    {.front = {0.06F, 0.122F, 0.15F}, .back = {0.857F, 0.555F, 0.346F}},  // slate, sand
    {.front = {0.84F, 0.328F, 0.44F}, .back = {0.065F, 0.157F, 0.05F}},   // rose, forest
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
