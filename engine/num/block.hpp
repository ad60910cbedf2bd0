#pragma once

#include "engine/num/scalar.hpp"
#include "engine/num/sleef.hpp"

#include <immintrin.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

// The carrier of the interpreter: a block of floats or doubles, each operation bit-equal to that of
// one number (engine/num/scalar.hpp); the elementary functions over doubles are those of kernels
// (`one_lane`).

namespace zeroset {

/// A register of the least processor.
template <class Real>
struct Register;
template <>
struct Register<float> {
    __m128 lanes;
};
template <>
struct Register<double> {
    __m128d lanes;
};

inline constexpr std::size_t block_registers = 4;

/// One bit for each lane.
struct BlockMask {
    std::uint16_t bits;
};

template <class Real>
struct Block {
    static constexpr std::size_t register_lanes = sizeof(Register<Real>) / sizeof(Real);
    static constexpr std::size_t lanes = block_registers * register_lanes;

    std::array<Register<Real>, block_registers> registers;

    /// The same number in all lanes.
    static Block splat(Real value);
};

// Operations that both registers have.
namespace detail {

inline __m128 splat(float x) { return _mm_set1_ps(x); }
inline __m128d splat(double x) { return _mm_set1_pd(x); }
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

/// By the sign bits of `sign`.
inline __m128 blend(__m128 sign, __m128 if_set, __m128 if_clear) {
    return _mm_blendv_ps(if_clear, if_set, sign);
}
inline __m128d blend(__m128d sign, __m128d if_set, __m128d if_clear) {
    return _mm_blendv_pd(if_clear, if_set, sign);
}

/// All ones or 0 for each lane, from the lowest bits.
inline __m128 lanes_of(int bits, float /*kind*/) {
    const __m128i each = _mm_setr_epi32(1, 2, 4, 8);
    return _mm_castsi128_ps(_mm_cmpeq_epi32(_mm_and_si128(_mm_set1_epi32(bits), each), each));
}
inline __m128d lanes_of(int bits, double /*kind*/) {
    const __m128i each = _mm_set_epi64x(2, 1);
    return _mm_castsi128_pd(_mm_cmpeq_epi64(_mm_and_si128(_mm_set1_epi64x(bits), each), each));
}

}  // namespace detail

/// function(a's register, b's register, ...) for each register.
template <class Real, class Function, class... Blocks>
Block<Real> by_registers(Function function, const Block<Real>& a, const Blocks&... others) {
    Block<Real> result;
    for (std::size_t i = 0; i < block_registers; ++i)
        result.registers[i].lanes = function(a.registers[i].lanes, others.registers[i].lanes...);
    return result;
}

/// The bits that function(a's register, b's register) gives.
template <class Real, class Function>
BlockMask mask_by_registers(Function function, const Block<Real>& a, const Block<Real>& b) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < block_registers; ++i) {
        const int part = function(a.registers[i].lanes, b.registers[i].lanes);
        bits |= static_cast<unsigned>(part) << (Block<Real>::register_lanes * i);
    }
    return {static_cast<std::uint16_t>(bits)};
}

template <class Real>
Block<Real> Block<Real>::splat(Real value) {
    Block block;
    block.registers.fill({detail::splat(value)});
    return block;
}

template <class Real>
Block<Real> operator+(const Block<Real>& a, const Block<Real>& b) {
    return by_registers([](auto x, auto y) { return detail::sum(x, y); }, a, b);
}
template <class Real>
Block<Real> operator-(const Block<Real>& a, const Block<Real>& b) {
    return by_registers([](auto x, auto y) { return detail::difference(x, y); }, a, b);
}
template <class Real>
Block<Real> operator*(const Block<Real>& a, const Block<Real>& b) {
    return by_registers([](auto x, auto y) { return detail::product(x, y); }, a, b);
}
template <class Real>
Block<Real> operator/(const Block<Real>& a, const Block<Real>& b) {
    return by_registers([](auto x, auto y) { return detail::quotient(x, y); }, a, b);
}
template <class Real>
Block<Real> operator-(const Block<Real>& a) {
    return by_registers([](auto x) { return detail::negated(x); }, a);
}

template <class Real>
BlockMask operator>(const Block<Real>& a, const Block<Real>& b) {
    return mask_by_registers([](auto x, auto y) { return detail::above(x, y); }, a, b);
}
template <class Real>
BlockMask operator>=(const Block<Real>& a, const Block<Real>& b) {
    return mask_by_registers([](auto x, auto y) { return detail::not_below(x, y); }, a, b);
}
template <class Real>
BlockMask operator<(const Block<Real>& a, const Block<Real>& b) {
    return b > a;
}
template <class Real>
BlockMask operator<=(const Block<Real>& a, const Block<Real>& b) {
    return b >= a;
}
template <class Real>
BlockMask operator==(const Block<Real>& a, const Block<Real>& b) {
    return mask_by_registers([](auto x, auto y) { return detail::equal(x, y); }, a, b);
}
template <class Real>
BlockMask unordered(const Block<Real>& a, const Block<Real>& b) {
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

template <class Real>
Block<Real> like(const Block<Real>& /*kind*/, double value) {
    return Block<Real>::splat(like(Real{}, value));
}
template <class Real>
Block<Real> select(const BlockMask& condition, const Block<Real>& if_true,
                   const Block<Real>& if_false) {
    Block<Real> result;
    for (std::size_t i = 0; i < block_registers; ++i) {
        const int bits = condition.bits >> (Block<Real>::register_lanes * i);
        result.registers[i].lanes =
            detail::blend(detail::lanes_of(bits, Real{}), if_true.registers[i].lanes,
                          if_false.registers[i].lanes);
    }
    return result;
}
template <class Real>
Block<Real> select_negative(const Block<Real>& x, const Block<Real>& if_set,
                            const Block<Real>& if_clear) {
    return by_registers(
        [](auto sign, auto set, auto clear) { return detail::blend(sign, set, clear); }, x, if_set,
        if_clear);
}
template <class Real>
Block<Real> maximum(const Block<Real>& a, const Block<Real>& b) {
    return by_registers([](auto x, auto y) { return detail::maximum(x, y); }, a, b);
}
template <class Real>
Block<Real> minimum(const Block<Real>& a, const Block<Real>& b) {
    return by_registers([](auto x, auto y) { return detail::minimum(x, y); }, a, b);
}
template <class Real>
Block<Real> square_root(const Block<Real>& a) {
    return by_registers([](auto x) { return detail::square_root(x); }, a);
}
template <class Real>
Block<Real> fused(const Block<Real>& a, const Block<Real>& b, const Block<Real>& c) {
    return a * b + c;
}
template <class Real>
Block<Real> magnitude(const Block<Real>& a) {
    return by_registers([](auto x) { return detail::magnitude(x); }, a);
}
template <class Real>
Block<Real> round_down(const Block<Real>& a) {
    return by_registers([](auto x) { return detail::round_down(x); }, a);
}

template <class Real>
const void* block_code(Elementary function) {
    return elementary_code(function, Block<Real>::register_lanes, format_of(Real{}).type);
}
template <class Real>
Block<Real> elementary(Elementary function, const Block<Real>& a) {
    using Lanes = decltype(Register<Real>::lanes);
    return by_registers(std::bit_cast<Lanes (*)(Lanes)>(block_code<Real>(function)), a);
}
template <class Real>
Block<Real> elementary(Elementary function, const Block<Real>& a, const Block<Real>& b) {
    using Lanes = decltype(Register<Real>::lanes);
    return by_registers(std::bit_cast<Lanes (*)(Lanes, Lanes)>(block_code<Real>(function)), a, b);
}

template <class Real>
const Format& format_of(const Block<Real>& /*kind*/) {
    return format_of(Real{});
}

}  // namespace zeroset
