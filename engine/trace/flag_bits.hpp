#pragma once

#include "engine/trace/tile_hits.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace zeroset {

/// The lowest bits of up to 64 bytes: of byte i in bit i.
template <std::size_t count>
std::uint64_t bits_of_flags(const std::array<std::uint8_t, count>& flags) {
    static_assert(count % 8 == 0 && count <= 64);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < count; i += 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, &flags[i], 8);
        // Gathers the lowest bits of eight bytes in the highest one.
        bits |= (eight * 0x0102040810204080U >> 56U) << i;
    }
    return bits;
}

}  // namespace zeroset
