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

/// Takes its background out of `frame`. `painted`: the frame with what was drawn over it, which
/// is not transparent.
RgbaImage without_background(const Framebuffer& frame, const Framebuffer& painted);

/// `frame`, whose sides are even, at half its size. Each pixel is the mean of the drawn ones among
/// four; its alpha is their share. Transparent pixels next to drawn ones take their colour, so that
/// a stretched picture has no fringe.
RgbaImage halved(const Framebuffer& frame);

}  // namespace zeroset
