#pragma once

// Operations on registers of 32 and 64 bytes, for engine/real/block.hpp alone. Empty where the
// translation unit is compiled without them.

#if ZEROSET_BLOCK_BYTES == 32
namespace zeroset::detail {

inline __m256 sum(__m256 x, __m256 y) { return _mm256_add_ps(x, y); }
inline __m256d sum(__m256d x, __m256d y) { return _mm256_add_pd(x, y); }
inline __m256 difference(__m256 x, __m256 y) { return _mm256_sub_ps(x, y); }
inline __m256d difference(__m256d x, __m256d y) { return _mm256_sub_pd(x, y); }
inline __m256 product(__m256 x, __m256 y) { return _mm256_mul_ps(x, y); }
inline __m256d product(__m256d x, __m256d y) { return _mm256_mul_pd(x, y); }
inline __m256 quotient(__m256 x, __m256 y) { return _mm256_div_ps(x, y); }
inline __m256d quotient(__m256d x, __m256d y) { return _mm256_div_pd(x, y); }
inline __m256 negated(__m256 x) { return _mm256_xor_ps(x, _mm256_set1_ps(-0.0F)); }
inline __m256 magnitude(__m256 x) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0F), x); }
inline __m256 maximum(__m256 x, __m256 y) { return _mm256_max_ps(x, y); }
inline __m256 minimum(__m256 x, __m256 y) { return _mm256_min_ps(x, y); }
inline __m256 square_root(__m256 x) { return _mm256_sqrt_ps(x); }
inline __m256 fused(__m256 x, __m256 y, __m256 z) { return _mm256_fmadd_ps(x, y, z); }
inline __m256 round_down(__m256 x) { return _mm256_floor_ps(x); }
inline int above(__m256 x, __m256 y) { return _mm256_movemask_ps(_mm256_cmp_ps(x, y, _CMP_GT_OQ)); }
inline int not_below(__m256 x, __m256 y) {
    return _mm256_movemask_ps(_mm256_cmp_ps(x, y, _CMP_GE_OQ));
}
inline int equal(__m256 x, __m256 y) { return _mm256_movemask_ps(_mm256_cmp_ps(x, y, _CMP_EQ_OQ)); }
inline int unordered(__m256 x, __m256 y) {
    return _mm256_movemask_ps(_mm256_cmp_ps(x, y, _CMP_UNORD_Q));
}
inline int sign_bits(__m256 x) { return _mm256_movemask_ps(x); }
inline __m256 blend(__m256 sign, __m256 if_set, __m256 if_clear) {
    return _mm256_blendv_ps(if_clear, if_set, sign);
}
inline __m256 choose(unsigned bits, __m256 if_set, __m256 if_clear) {
    const __m256i each = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i all = _mm256_set1_epi32(static_cast<int>(bits));
    const __m256i mask = _mm256_cmpeq_epi32(_mm256_and_si256(all, each), each);
    return _mm256_blendv_ps(if_clear, if_set, _mm256_castsi256_ps(mask));
}
inline __m256d negated(__m256d x) { return _mm256_xor_pd(x, _mm256_set1_pd(-0.0)); }
inline __m256d magnitude(__m256d x) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), x); }
inline __m256d maximum(__m256d x, __m256d y) { return _mm256_max_pd(x, y); }
inline __m256d minimum(__m256d x, __m256d y) { return _mm256_min_pd(x, y); }
inline __m256d square_root(__m256d x) { return _mm256_sqrt_pd(x); }
inline __m256d fused(__m256d x, __m256d y, __m256d z) { return _mm256_fmadd_pd(x, y, z); }
inline __m256d round_down(__m256d x) { return _mm256_floor_pd(x); }
inline int above(__m256d x, __m256d y) {
    return _mm256_movemask_pd(_mm256_cmp_pd(x, y, _CMP_GT_OQ));
}
inline int not_below(__m256d x, __m256d y) {
    return _mm256_movemask_pd(_mm256_cmp_pd(x, y, _CMP_GE_OQ));
}
inline int equal(__m256d x, __m256d y) {
    return _mm256_movemask_pd(_mm256_cmp_pd(x, y, _CMP_EQ_OQ));
}
inline int unordered(__m256d x, __m256d y) {
    return _mm256_movemask_pd(_mm256_cmp_pd(x, y, _CMP_UNORD_Q));
}
inline int sign_bits(__m256d x) { return _mm256_movemask_pd(x); }
inline __m256d blend(__m256d sign, __m256d if_set, __m256d if_clear) {
    return _mm256_blendv_pd(if_clear, if_set, sign);
}
inline __m256d choose(unsigned bits, __m256d if_set, __m256d if_clear) {
    const __m256i each = _mm256_setr_epi64x(1, 2, 4, 8);
    const __m256i mask = _mm256_cmpeq_epi64(_mm256_and_si256(_mm256_set1_epi64x(bits), each), each);
    return _mm256_blendv_pd(if_clear, if_set, _mm256_castsi256_pd(mask));
}

}  // namespace zeroset::detail
#endif

#if ZEROSET_BLOCK_BYTES == 64
namespace zeroset::detail {

inline __m512 sum(__m512 x, __m512 y) { return _mm512_add_ps(x, y); }
inline __m512d sum(__m512d x, __m512d y) { return _mm512_add_pd(x, y); }
inline __m512 difference(__m512 x, __m512 y) { return _mm512_sub_ps(x, y); }
inline __m512d difference(__m512d x, __m512d y) { return _mm512_sub_pd(x, y); }
inline __m512 product(__m512 x, __m512 y) { return _mm512_mul_ps(x, y); }
inline __m512d product(__m512d x, __m512d y) { return _mm512_mul_pd(x, y); }
inline __m512 quotient(__m512 x, __m512 y) { return _mm512_div_ps(x, y); }
inline __m512d quotient(__m512d x, __m512d y) { return _mm512_div_pd(x, y); }
inline __m512 negated(__m512 x) { return _mm512_xor_ps(x, _mm512_set1_ps(-0.0F)); }
inline __m512 magnitude(__m512 x) { return _mm512_andnot_ps(_mm512_set1_ps(-0.0F), x); }
inline __m512 maximum(__m512 x, __m512 y) { return _mm512_max_ps(x, y); }
inline __m512 minimum(__m512 x, __m512 y) { return _mm512_min_ps(x, y); }
inline __m512 square_root(__m512 x) { return _mm512_sqrt_ps(x); }
inline __m512 fused(__m512 x, __m512 y, __m512 z) { return _mm512_fmadd_ps(x, y, z); }
inline __m512 round_down(__m512 x) {
    return _mm512_roundscale_ps(x, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}
inline int above(__m512 x, __m512 y) { return _mm512_cmp_ps_mask(x, y, _CMP_GT_OQ); }
inline int not_below(__m512 x, __m512 y) { return _mm512_cmp_ps_mask(x, y, _CMP_GE_OQ); }
inline int equal(__m512 x, __m512 y) { return _mm512_cmp_ps_mask(x, y, _CMP_EQ_OQ); }
inline int unordered(__m512 x, __m512 y) { return _mm512_cmp_ps_mask(x, y, _CMP_UNORD_Q); }
inline int sign_bits(__m512 x) { return _mm512_movepi32_mask(_mm512_castps_si512(x)); }
inline __m512 blend(__m512 sign, __m512 if_set, __m512 if_clear) {
    return _mm512_mask_blend_ps(static_cast<__mmask16>(sign_bits(sign)), if_clear, if_set);
}
inline __m512 choose(unsigned bits, __m512 if_set, __m512 if_clear) {
    return _mm512_mask_blend_ps(static_cast<__mmask16>(bits), if_clear, if_set);
}
inline __m512d negated(__m512d x) { return _mm512_xor_pd(x, _mm512_set1_pd(-0.0)); }
inline __m512d magnitude(__m512d x) { return _mm512_andnot_pd(_mm512_set1_pd(-0.0), x); }
inline __m512d maximum(__m512d x, __m512d y) { return _mm512_max_pd(x, y); }
inline __m512d minimum(__m512d x, __m512d y) { return _mm512_min_pd(x, y); }
inline __m512d square_root(__m512d x) { return _mm512_sqrt_pd(x); }
inline __m512d fused(__m512d x, __m512d y, __m512d z) { return _mm512_fmadd_pd(x, y, z); }
inline __m512d round_down(__m512d x) {
    return _mm512_roundscale_pd(x, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}
inline int above(__m512d x, __m512d y) { return _mm512_cmp_pd_mask(x, y, _CMP_GT_OQ); }
inline int not_below(__m512d x, __m512d y) { return _mm512_cmp_pd_mask(x, y, _CMP_GE_OQ); }
inline int equal(__m512d x, __m512d y) { return _mm512_cmp_pd_mask(x, y, _CMP_EQ_OQ); }
inline int unordered(__m512d x, __m512d y) { return _mm512_cmp_pd_mask(x, y, _CMP_UNORD_Q); }
inline int sign_bits(__m512d x) { return _mm512_movepi64_mask(_mm512_castpd_si512(x)); }
inline __m512d blend(__m512d sign, __m512d if_set, __m512d if_clear) {
    return _mm512_mask_blend_pd(static_cast<__mmask8>(sign_bits(sign)), if_clear, if_set);
}
inline __m512d choose(unsigned bits, __m512d if_set, __m512d if_clear) {
    return _mm512_mask_blend_pd(static_cast<__mmask8>(bits), if_clear, if_set);
}

}  // namespace zeroset::detail
#endif
