#pragma once

#include "engine/real/field.hpp"
#include "engine/real/scalar.hpp"
#include "engine/real/sleef.hpp"

#include <immintrin.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

// The carrier of the interpreter: a block of floats or doubles in registers of 16 bytes, or of 32
// or 64 bytes where the translation unit is compiled for machines that have them. Each operation is
// bit-equal to that of a single number (engine/real/scalar.hpp), except the fused ones of wide
// registers. The elementary functions over doubles are those of kernels (`one_lane`).

#ifndef ZEROSET_BLOCK_BYTES
#define ZEROSET_BLOCK_BYTES 16
#endif

namespace zeroset {

/// A vector register of `bytes` bytes.
template <class Real, std::size_t bytes>
struct Register;
template <>
struct Register<float, 16> {
    __m128 lanes;
};
template <>
struct Register<double, 16> {
    __m128d lanes;
};
#if ZEROSET_BLOCK_BYTES == 32
template <>
struct Register<float, 32> {
    __m256 lanes;
};
template <>
struct Register<double, 32> {
    __m256d lanes;
};
#endif
#if ZEROSET_BLOCK_BYTES == 64
template <>
struct Register<float, 64> {
    __m512 lanes;
};
template <>
struct Register<double, 64> {
    __m512d lanes;
};
#endif

/// Size of a block, whatever its registers.
inline constexpr std::size_t block_bytes = 64;

/// Mask of a block: one bit for each lane, the first lane lowest.
struct BlockMask {
    std::uint16_t bits;
};

template <class Real, std::size_t bytes = 16>
struct Block {
    static constexpr std::size_t register_lanes = bytes / sizeof(Real);
    static constexpr std::size_t lanes = block_bytes / sizeof(Real);

    std::array<Register<Real, bytes>, block_bytes / bytes> registers;

    /// A block with `value` in all lanes.
    static Block splat(Real value);
};

// Operations on one register: those of 16 bytes, and splat for all. block_wide.hpp has the others.
namespace detail {

template <std::size_t bytes>
auto splat(float x) {
    if constexpr (bytes == 16) {
        return _mm_set1_ps(x);
#if ZEROSET_BLOCK_BYTES == 32
    } else if constexpr (bytes == 32) {
        return _mm256_set1_ps(x);
#endif
#if ZEROSET_BLOCK_BYTES == 64
    } else {
        return _mm512_set1_ps(x);
#endif
    }
}
template <std::size_t bytes>
auto splat(double x) {
    if constexpr (bytes == 16) {
        return _mm_set1_pd(x);
#if ZEROSET_BLOCK_BYTES == 32
    } else if constexpr (bytes == 32) {
        return _mm256_set1_pd(x);
#endif
#if ZEROSET_BLOCK_BYTES == 64
    } else {
        return _mm512_set1_pd(x);
#endif
    }
}
inline __m128 sum(__m128 x, __m128 y) { return _mm_add_ps(x, y); }
inline __m128d sum(__m128d x, __m128d y) { return _mm_add_pd(x, y); }
inline __m128 difference(__m128 x, __m128 y) { return _mm_sub_ps(x, y); }
inline __m128d difference(__m128d x, __m128d y) { return _mm_sub_pd(x, y); }
inline __m128 product(__m128 x, __m128 y) { return _mm_mul_ps(x, y); }
inline __m128d product(__m128d x, __m128d y) { return _mm_mul_pd(x, y); }
inline __m128 quotient(__m128 x, __m128 y) { return _mm_div_ps(x, y); }
inline __m128d quotient(__m128d x, __m128d y) { return _mm_div_pd(x, y); }
inline __m128 negated(__m128 x) { return _mm_xor_ps(x, _mm_set1_ps(-0.0F)); }
inline __m128d negated(__m128d x) { return _mm_xor_pd(x, _mm_set1_pd(-0.0)); }
inline __m128 magnitude(__m128 x) { return _mm_andnot_ps(_mm_set1_ps(-0.0F), x); }
inline __m128d magnitude(__m128d x) { return _mm_andnot_pd(_mm_set1_pd(-0.0), x); }
inline __m128 maximum(__m128 x, __m128 y) { return _mm_max_ps(x, y); }
inline __m128d maximum(__m128d x, __m128d y) { return _mm_max_pd(x, y); }
inline __m128 minimum(__m128 x, __m128 y) { return _mm_min_ps(x, y); }
inline __m128d minimum(__m128d x, __m128d y) { return _mm_min_pd(x, y); }
inline __m128 square_root(__m128 x) { return _mm_sqrt_ps(x); }
inline __m128d square_root(__m128d x) { return _mm_sqrt_pd(x); }
inline __m128 round_down(__m128 x) { return _mm_floor_ps(x); }
inline __m128d round_down(__m128d x) { return _mm_floor_pd(x); }

inline int above(__m128 x, __m128 y) { return _mm_movemask_ps(_mm_cmpgt_ps(x, y)); }
inline int above(__m128d x, __m128d y) { return _mm_movemask_pd(_mm_cmpgt_pd(x, y)); }
inline int not_below(__m128 x, __m128 y) { return _mm_movemask_ps(_mm_cmpge_ps(x, y)); }
inline int not_below(__m128d x, __m128d y) { return _mm_movemask_pd(_mm_cmpge_pd(x, y)); }
inline int equal(__m128 x, __m128 y) { return _mm_movemask_ps(_mm_cmpeq_ps(x, y)); }
inline int equal(__m128d x, __m128d y) { return _mm_movemask_pd(_mm_cmpeq_pd(x, y)); }
inline int unordered(__m128 x, __m128 y) { return _mm_movemask_ps(_mm_cmpunord_ps(x, y)); }
inline int unordered(__m128d x, __m128d y) { return _mm_movemask_pd(_mm_cmpunord_pd(x, y)); }

inline int sign_bits(__m128 x) { return _mm_movemask_ps(x); }
inline int sign_bits(__m128d x) { return _mm_movemask_pd(x); }

/// `if_set` where the sign bit of `sign` is set, else `if_clear`.
inline __m128 blend(__m128 sign, __m128 if_set, __m128 if_clear) {
    return _mm_blendv_ps(if_clear, if_set, sign);
}
inline __m128d blend(__m128d sign, __m128d if_set, __m128d if_clear) {
    return _mm_blendv_pd(if_clear, if_set, sign);
}

/// `if_set` where the lane's bit is set, else `if_clear`; lane i has bit i of `bits`.
inline __m128 choose(unsigned bits, __m128 if_set, __m128 if_clear) {
    const __m128i each = _mm_setr_epi32(1, 2, 4, 8);
    const __m128i all = _mm_set1_epi32(static_cast<int>(bits));
    const __m128i mask = _mm_cmpeq_epi32(_mm_and_si128(all, each), each);
    return _mm_blendv_ps(if_clear, if_set, _mm_castsi128_ps(mask));
}
inline __m128d choose(unsigned bits, __m128d if_set, __m128d if_clear) {
    const __m128i each = _mm_set_epi64x(2, 1);
    const __m128i mask = _mm_cmpeq_epi64(_mm_and_si128(_mm_set1_epi64x(bits), each), each);
    return _mm_blendv_pd(if_clear, if_set, _mm_castsi128_pd(mask));
}

inline __m128 fused(__m128 x, __m128 y, __m128 z) { return _mm_add_ps(_mm_mul_ps(x, y), z); }
inline __m128d fused(__m128d x, __m128d y, __m128d z) { return _mm_add_pd(_mm_mul_pd(x, y), z); }

}  // namespace detail
}  // namespace zeroset

#include "engine/real/block_wide.hpp"

namespace zeroset {

/// The block of the results of function(a's register, b's register, ...) for each register.
template <class Real, std::size_t bytes, class Function, class... Blocks>
Block<Real, bytes> by_registers(Function function, const Block<Real, bytes>& a,
                                const Blocks&... others) {
    Block<Real, bytes> result;
    for (std::size_t i = 0; i < a.registers.size(); ++i)
        result.registers[i].lanes = function(a.registers[i].lanes, others.registers[i].lanes...);
    return result;
}

/// The mask of the bits that function(a's register, b's register) returns for each register.
template <class Real, std::size_t bytes, class Function>
BlockMask mask_by_registers(Function function, const Block<Real, bytes>& a,
                            const Block<Real, bytes>& b) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < a.registers.size(); ++i) {
        const int part = function(a.registers[i].lanes, b.registers[i].lanes);
        bits |= static_cast<unsigned>(part) << (Block<Real, bytes>::register_lanes * i);
    }
    return {static_cast<std::uint16_t>(bits)};
}

template <class Real, std::size_t bytes>
Block<Real, bytes> Block<Real, bytes>::splat(Real value) {
    Block block;
    for (auto& part : block.registers)
        part = {detail::splat<bytes>(value)};
    return block;
}

template <class Real, std::size_t bytes>
Block<Real, bytes> operator+(const Block<Real, bytes>& a, const Block<Real, bytes>& b) {
    return by_registers([](auto x, auto y) { return detail::sum(x, y); }, a, b);
}
template <class Real, std::size_t bytes>
Block<Real, bytes> operator-(const Block<Real, bytes>& a, const Block<Real, bytes>& b) {
    return by_registers([](auto x, auto y) { return detail::difference(x, y); }, a, b);
}
template <class Real, std::size_t bytes>
Block<Real, bytes> operator*(const Block<Real, bytes>& a, const Block<Real, bytes>& b) {
    return by_registers([](auto x, auto y) { return detail::product(x, y); }, a, b);
}
template <class Real, std::size_t bytes>
Block<Real, bytes> operator/(const Block<Real, bytes>& a, const Block<Real, bytes>& b) {
    return by_registers([](auto x, auto y) { return detail::quotient(x, y); }, a, b);
}
template <class Real, std::size_t bytes>
Block<Real, bytes> operator-(const Block<Real, bytes>& a) {
    return by_registers([](auto x) { return detail::negated(x); }, a);
}

template <class Real, std::size_t bytes>
BlockMask operator>(const Block<Real, bytes>& a, const Block<Real, bytes>& b) {
    return mask_by_registers([](auto x, auto y) { return detail::above(x, y); }, a, b);
}
template <class Real, std::size_t bytes>
BlockMask operator>=(const Block<Real, bytes>& a, const Block<Real, bytes>& b) {
    return mask_by_registers([](auto x, auto y) { return detail::not_below(x, y); }, a, b);
}
template <class Real, std::size_t bytes>
BlockMask operator<(const Block<Real, bytes>& a, const Block<Real, bytes>& b) {
    return b > a;
}
template <class Real, std::size_t bytes>
BlockMask operator<=(const Block<Real, bytes>& a, const Block<Real, bytes>& b) {
    return b >= a;
}
template <class Real, std::size_t bytes>
BlockMask operator==(const Block<Real, bytes>& a, const Block<Real, bytes>& b) {
    return mask_by_registers([](auto x, auto y) { return detail::equal(x, y); }, a, b);
}
template <class Real, std::size_t bytes>
BlockMask unordered(const Block<Real, bytes>& a, const Block<Real, bytes>& b) {
    return mask_by_registers([](auto x, auto y) { return detail::unordered(x, y); }, a, b);
}

inline BlockMask both(const BlockMask& a, const BlockMask& b) {
    return {static_cast<std::uint16_t>(a.bits & b.bits)};
}
inline BlockMask either(const BlockMask& a, const BlockMask& b) {
    return {static_cast<std::uint16_t>(a.bits | b.bits)};
}
inline BlockMask no(const BlockMask& a) { return {static_cast<std::uint16_t>(~a.bits)}; }
inline bool identical(const BlockMask& a, const BlockMask& b) { return a.bits == b.bits; }

template <class Real, std::size_t bytes>
Block<Real, bytes> like(const Block<Real, bytes>& /*kind*/, double value) {
    return Block<Real, bytes>::splat(like(Real{}, value));
}
template <class Real, std::size_t bytes>
Block<Real, bytes> select(const BlockMask& condition, const Block<Real, bytes>& if_true,
                          const Block<Real, bytes>& if_false) {
    Block<Real, bytes> result;
    for (std::size_t i = 0; i < result.registers.size(); ++i) {
        const unsigned bits =
            static_cast<unsigned>(condition.bits) >> (Block<Real, bytes>::register_lanes * i);
        result.registers[i].lanes =
            detail::choose(bits, if_true.registers[i].lanes, if_false.registers[i].lanes);
    }
    return result;
}
template <class Real, std::size_t bytes>
Block<Real, bytes> select_negative(const Block<Real, bytes>& x, const Block<Real, bytes>& if_set,
                                   const Block<Real, bytes>& if_clear) {
    return by_registers(
        [](auto sign, auto set, auto clear) { return detail::blend(sign, set, clear); }, x, if_set,
        if_clear);
}
template <class Real, std::size_t bytes>
Block<Real, bytes> maximum(const Block<Real, bytes>& a, const Block<Real, bytes>& b) {
    return by_registers([](auto x, auto y) { return detail::maximum(x, y); }, a, b);
}
template <class Real, std::size_t bytes>
Block<Real, bytes> minimum(const Block<Real, bytes>& a, const Block<Real, bytes>& b) {
    return by_registers([](auto x, auto y) { return detail::minimum(x, y); }, a, b);
}
template <class Real, std::size_t bytes>
Block<Real, bytes> square_root(const Block<Real, bytes>& a) {
    return by_registers([](auto x) { return detail::square_root(x); }, a);
}
template <class Real, std::size_t bytes>
Block<Real, bytes> fused(const Block<Real, bytes>& a, const Block<Real, bytes>& b,
                         const Block<Real, bytes>& c) {
    return by_registers([](auto x, auto y, auto z) { return detail::fused(x, y, z); }, a, b, c);
}
template <class Real, std::size_t bytes>
Block<Real, bytes> magnitude(const Block<Real, bytes>& a) {
    return by_registers([](auto x) { return detail::magnitude(x); }, a);
}
template <class Real, std::size_t bytes>
Block<Real, bytes> round_down(const Block<Real, bytes>& a) {
    return by_registers([](auto x) { return detail::round_down(x); }, a);
}

template <class Real, std::size_t bytes>
const void* block_code(Elementary function) {
    return elementary_code(function, static_cast<int>(Block<Real, bytes>::register_lanes),
                           format_of(Real{}).type);
}
template <class Real, std::size_t bytes>
Block<Real, bytes> elementary(Elementary function, const Block<Real, bytes>& a) {
    using Lanes = decltype(Register<Real, bytes>::lanes);
    return by_registers(std::bit_cast<Lanes (*)(Lanes)>(block_code<Real, bytes>(function)), a);
}
template <class Real, std::size_t bytes>
Block<Real, bytes> elementary(Elementary function, const Block<Real, bytes>& a,
                              const Block<Real, bytes>& b) {
    using Lanes = decltype(Register<Real, bytes>::lanes);
    return by_registers(std::bit_cast<Lanes (*)(Lanes, Lanes)>(block_code<Real, bytes>(function)),
                        a, b);
}

template <class Real, std::size_t bytes>
const Format& format_of(const Block<Real, bytes>& /*kind*/) {
    return format_of(Real{});
}

/// The answers of a field (engine/real/field.hpp).
template <class Question, class Real, std::size_t bytes>
std::array<Block<Real, bytes>, Question::answers> answers(
    Question /*question*/, const Field& field, int derivative,
    const std::array<Block<Real, bytes>, Question::questions>& in) {
    std::array<Block<Real, bytes>, Question::answers> out;
    static_assert(sizeof out == Question::answers * block_bytes);
    ask<Question>(field, derivative, reinterpret_cast<const Real*>(&in),
                  reinterpret_cast<Real*>(&out), static_cast<int>(Block<Real, bytes>::lanes));
    return out;
}

}  // namespace zeroset
