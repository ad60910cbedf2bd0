#pragma once

#include <algorithm>
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

}  // namespace zeroset
