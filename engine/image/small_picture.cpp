#include "engine/image/frame_pictures.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {
namespace {

std::size_t index(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
}

}  // namespace

void take_over(const Framebuffer& frame, int row, int rows, int most_px, RgbaImage& small) {
    const double step = std::max(
        {1.0, static_cast<double>(frame.width) / most_px, static_cast<double>(rows) / most_px});
    const int width = std::max(static_cast<int>(frame.width / step), 1);
    const int height = std::max(static_cast<int>(rows / step), 1);
    if (small.width != width || small.height != height) {
        small = {.width = width,
                 .height = height,
                 .pixels = std::vector<std::uint32_t>(index(0, height, width))};
    }
    for (int y = 0; y < height; ++y) {
        const int from = static_cast<int>((y + 0.5) * step) - row;
        if (from < 0 || from >= frame.height) continue;
        for (int x = 0; x < width; ++x) {
            const int column = std::min(static_cast<int>((x + 0.5) * step), frame.width - 1);
            small.pixels[index(x, y, width)] =
                frame.color[index(column, from, frame.width)] | 0xFF000000U;
        }
    }
}

}  // namespace zeroset
