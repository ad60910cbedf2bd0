#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace zeroset {

/// The curve between linear light and the channels of a picture: gamma 2. Both are 0 to 1.
/// `engine/light/encode.cpp` has the same curve for whole vectors of pixels.
template <class T>
constexpr T gamma_decoded(const T& shown) {
    return shown * shown;
}

/// The linear light of a channel of 8 bits.
constexpr float light_of_channel(std::uint32_t channel) {
    return gamma_decoded(static_cast<float>(channel) / 255.0F);
}

/// The channel of 8 bits, 0 to 255, nearest to a linear light; light out of range is clamped.
inline std::uint32_t channel_of_light(float light) {
    const float shown = std::sqrt(std::clamp(light, 0.0F, 1.0F));
    return static_cast<std::uint32_t>(shown * 255.0F + 0.5F);
}

/// The linear light, red, green and blue, of a colour 0xRRGGBB; and the colour nearest to a light.
constexpr std::array<float, 3> light_of_color(std::uint32_t color) {
    return {light_of_channel(color >> 16U & 0xFFU), light_of_channel(color >> 8U & 0xFFU),
            light_of_channel(color & 0xFFU)};
}
inline std::uint32_t color_of_light(const std::array<float, 3>& light) {
    return channel_of_light(light[0]) << 16U | channel_of_light(light[1]) << 8U |
           channel_of_light(light[2]);
}

}  // namespace zeroset
