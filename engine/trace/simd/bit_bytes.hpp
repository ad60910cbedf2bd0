#pragma once

#include <cstdint>

namespace zeroset {

/// A byte for each of the eight lowest bits, the lowest first: 0xFF where it is set, else 0.
constexpr std::uint64_t bytes_of_bits(std::uint64_t bits) {
    const std::uint64_t spread = (bits * 0x0101010101010101U) & 0x8040201008040201U;
    const std::uint64_t set = ((spread + 0x7F7F7F7F7F7F7F7FU) | spread) >> 7U;
    return (set & 0x0101010101010101U) * 0xFFU;
}

static_assert(bytes_of_bits(0b10000101) == 0xFF00000000FF00FFU);

}  // namespace zeroset
