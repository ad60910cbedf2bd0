#pragma once

#include "engine/image/framebuffer.hpp"

#include <cstdint>
#include <vector>

namespace zeroset {

/// A picture with transparency, row 0 at the top. Colours as in Framebuffer, not multiplied by
/// their alpha.
struct RgbaImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> pixels;
    bool operator==(const RgbaImage&) const = default;
};

/// Half the size of `frame`, which has even sides: each pixel the mean of the drawn ones among
/// four, as opaque as they are many. Pixels without any next to drawn ones take those colours, so
/// that a stretched picture has no fringe.
RgbaImage halved(const Framebuffer& frame);

}  // namespace zeroset
