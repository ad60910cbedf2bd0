#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace zeroset {

/// Linear reflectances of a surface's two sides: red, green and blue, 0 to 1.
struct SurfaceColors {
    float front[3];  ///< where f > 0 at the viewer, or the outside of a solid
    float back[3];
};

/// Pairs that people with any of the usual kinds of colour vision can tell apart.
std::span<const SurfaceColors> palette();

/// The colours of surface number `surface`: the palette's, over and over.
const SurfaceColors& colors_of(std::size_t surface);

/// How a side with these reflectances shows in full light: RGBA as in Framebuffer::color.
std::uint32_t swatch_color(const float (&side)[3]);
/// How the front of a surface shows in full light: RGBA as in Framebuffer::color.
std::uint32_t swatch_color(std::size_t surface);

}  // namespace zeroset
