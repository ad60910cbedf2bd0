#pragma once

#include "engine/num/scalar.hpp"
#include "engine/num/sleef.hpp"

#include <immintrin.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

// The carrier of the interpreter: a block of floats, each operation bit-equal to that of a float
// (engine/num/scalar.hpp).

namespace zeroset {

inline constexpr std::size_t block_quads = 4;  ///< registers of the least processor
inline constexpr std::size_t block_lanes = 4 * block_quads;

/// One bit for each lane.
struct BlockMask {
    std::uint16_t bits;
};

struct Block {
    struct Quad {
        __m128 lanes;
    };
    std::array<Quad, block_quads> quads;

    /// The same number in all lanes.
    static Block splat(float value) {
        Block block;
        block.quads.fill({_mm_set1_ps(value)});
        return block;
    }
};

/// function(a's quad, b's quad, ...) for each quad.
template <class Function, class... Blocks>
Block by_quads(Function function, const Blocks&... blocks) {
    Block result;
    for (std::size_t i = 0; i < block_quads; ++i)
        result.quads[i].lanes = function(blocks.quads[i].lanes...);
    return result;
}

/// Where function(a's quad, b's quad) is all ones.
template <class Function>
BlockMask mask_by_quads(Function function, const Block& a, const Block& b) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < block_quads; ++i) {
        const int quad = _mm_movemask_ps(function(a.quads[i].lanes, b.quads[i].lanes));
        bits |= static_cast<unsigned>(quad) << (4 * i);
    }
    return {static_cast<std::uint16_t>(bits)};
}

/// All ones or 0 for each lane of a quad.
inline __m128 lanes_of(const BlockMask& mask, std::size_t quad) {
    const __m128i bits = _mm_set1_epi32(mask.bits >> (4 * quad));
    const __m128i each = _mm_setr_epi32(1, 2, 4, 8);
    return _mm_castsi128_ps(_mm_cmpeq_epi32(_mm_and_si128(bits, each), each));
}

inline Block operator+(const Block& a, const Block& b) {
    return by_quads([](__m128 x, __m128 y) { return _mm_add_ps(x, y); }, a, b);
}
inline Block operator-(const Block& a, const Block& b) {
    return by_quads([](__m128 x, __m128 y) { return _mm_sub_ps(x, y); }, a, b);
}
inline Block operator*(const Block& a, const Block& b) {
    return by_quads([](__m128 x, __m128 y) { return _mm_mul_ps(x, y); }, a, b);
}
inline Block operator/(const Block& a, const Block& b) {
    return by_quads([](__m128 x, __m128 y) { return _mm_div_ps(x, y); }, a, b);
}
inline Block operator-(const Block& a) {
    return by_quads([](__m128 x) { return _mm_xor_ps(x, _mm_set1_ps(-0.0F)); }, a);
}

inline BlockMask operator>(const Block& a, const Block& b) {
    return mask_by_quads([](__m128 x, __m128 y) { return _mm_cmpgt_ps(x, y); }, a, b);
}
inline BlockMask operator>=(const Block& a, const Block& b) {
    return mask_by_quads([](__m128 x, __m128 y) { return _mm_cmpge_ps(x, y); }, a, b);
}
inline BlockMask operator<(const Block& a, const Block& b) { return b > a; }
inline BlockMask operator<=(const Block& a, const Block& b) { return b >= a; }
inline BlockMask operator==(const Block& a, const Block& b) {
    return mask_by_quads([](__m128 x, __m128 y) { return _mm_cmpeq_ps(x, y); }, a, b);
}
inline BlockMask unordered(const Block& a, const Block& b) {
    return mask_by_quads([](__m128 x, __m128 y) { return _mm_cmpunord_ps(x, y); }, a, b);
}

inline BlockMask both(const BlockMask& a, const BlockMask& b) {
    return {static_cast<std::uint16_t>(a.bits & b.bits)};
}
inline BlockMask either(const BlockMask& a, const BlockMask& b) {
    return {static_cast<std::uint16_t>(a.bits | b.bits)};
}
inline BlockMask no(const BlockMask& a) { return {static_cast<std::uint16_t>(~a.bits)}; }
inline bool identical(const BlockMask& a, const BlockMask& b) { return a.bits == b.bits; }

inline Block like(const Block& /*kind*/, double value) { return Block::splat(like(0.0F, value)); }
inline Block select(const BlockMask& condition, const Block& if_true, const Block& if_false) {
    Block result;
    for (std::size_t i = 0; i < block_quads; ++i) {
        result.quads[i].lanes =
            _mm_blendv_ps(if_false.quads[i].lanes, if_true.quads[i].lanes, lanes_of(condition, i));
    }
    return result;
}
inline Block select_negative(const Block& x, const Block& if_set, const Block& if_clear) {
    return by_quads(
        [](__m128 sign, __m128 set, __m128 clear) { return _mm_blendv_ps(clear, set, sign); }, x,
        if_set, if_clear);
}
inline Block maximum(const Block& a, const Block& b) {
    return by_quads([](__m128 x, __m128 y) { return _mm_max_ps(x, y); }, a, b);
}
inline Block minimum(const Block& a, const Block& b) {
    return by_quads([](__m128 x, __m128 y) { return _mm_min_ps(x, y); }, a, b);
}
inline Block square_root(const Block& a) {
    return by_quads([](__m128 x) { return _mm_sqrt_ps(x); }, a);
}
inline Block magnitude(const Block& a) {
    return by_quads([](__m128 x) { return _mm_andnot_ps(_mm_set1_ps(-0.0F), x); }, a);
}
inline Block round_down(const Block& a) {
    return by_quads([](__m128 x) { return _mm_floor_ps(x); }, a);
}

inline Block elementary(Elementary function, const Block& a) {
    const auto code = std::bit_cast<__m128 (*)(__m128)>(elementary_code(function, 4));
    return by_quads(code, a);
}
inline Block elementary(Elementary function, const Block& a, const Block& b) {
    const auto code = std::bit_cast<__m128 (*)(__m128, __m128)>(elementary_code(function, 4));
    return by_quads(code, a, b);
}

// The numbers of float.
inline bool representable(double value, const Block& /*kind*/) {
    return representable(value, 0.0F);
}
inline double relative_gap(const Block& /*kind*/) { return relative_gap(0.0F); }
inline double smallest_normal(const Block& /*kind*/) { return smallest_normal(0.0F); }
inline double largest_finite(const Block& /*kind*/) { return largest_finite(0.0F); }

}  // namespace zeroset
