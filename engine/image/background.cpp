#include "engine/image/background.hpp"

#include "engine/image/gamma.hpp"

namespace zeroset {
namespace {

/// A channel of the background at a row, 0 to 255.
double channel_at(const Background& background, unsigned shift, int row, int height) {
    const double t = (row + 0.5) / height;
    const double top = background.top >> shift & 0xFFU;
    const double bottom = background.bottom >> shift & 0xFFU;
    return top + t * (bottom - top);
}

}  // namespace

std::uint32_t background_color(const Background& background, int row, int height) {
    const auto channel = [&](unsigned shift) {
        return static_cast<std::uint32_t>(channel_at(background, shift, row, height));
    };
    return 0xFF000000U | channel(0) << 16U | channel(8) << 8U | channel(16);
}

std::array<float, 3> background_light(const Background& background, int row, int height) {
    const auto light = [&](unsigned shift) {
        return gamma_decoded(static_cast<float>(channel_at(background, shift, row, height) / 255));
    };
    return {light(16), light(8), light(0)};
}

}  // namespace zeroset
