#pragma once

#include "engine/trace/tile_hits.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace zeroset {

/// The lowest bits of a row's bytes: of byte i in bit i.
inline std::uint64_t bits_of_flags(const std::array<std::uint8_t, tile_size>& flags) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < tile_size; i += 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, &flags[i], 8);
        // Gathers the lowest bits of eight bytes in the highest one.
        bits |= (eight * 0x0102040810204080U >> 56U) << i;
    }
    return bits;
}

}  // namespace zeroset
