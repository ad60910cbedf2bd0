#pragma once

#include "engine/image/framebuffer.hpp"

#include <cstdint>
#include <vector>

namespace zeroset {

/// A picture with transparency, row 0 at the top. Colours are as in Framebuffer, not multiplied by
/// alpha.
struct RgbaImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> pixels;
    bool operator==(const RgbaImage&) const = default;
};

/// The colour of a pixel of `frame` without its background, a colour as of Framebuffer; 0: only
/// that is seen. `painted`: the frame with what was drawn over it; a pixel that it has changed is
/// without its background there.
std::uint32_t drawn_color(const Framebuffer& frame, const Framebuffer& painted, std::size_t pixel,
                          std::uint32_t background);

/// `frame`, whose sides are even, at half its size. Each pixel is the mean of the drawn ones among
/// four; its alpha is their share. Transparent pixels next to drawn ones take their colour, so that
/// a stretched picture has no fringe.
RgbaImage halved(const Framebuffer& frame);

}  // namespace zeroset
