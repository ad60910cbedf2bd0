#include <immintrin.h>
#include <sleef.h>

#include "engine/num/rounding.hpp"
#include "engine/num/sleef_lanes.hpp"

#define LOOKUP sleef_avx512_16
#define VECTOR __m512
#define NAME(name, accuracy) Sleef_finz_##name##f16_##accuracy##avx512f
#include "engine/num/sleef_lanes.inc"
