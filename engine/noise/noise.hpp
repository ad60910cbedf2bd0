#pragma once

#include "engine/real/field.hpp"

#include <cstdint>
#include <memory>
#include <string_view>

namespace zeroset {

enum class NoiseWord : std::uint8_t { Noise, ValueNoise, Cellular, Cellular2 };

/// The word that a text has for it.
std::string_view noise_name(NoiseWord word);

/// The noise of a seed: the same object each time, so that code made for it is found again. It is
/// printed as it is typed, with the seed behind the point unless that is 0.
std::shared_ptr<const Field> noise_field(NoiseWord word, std::uint32_t seed);

}  // namespace zeroset
