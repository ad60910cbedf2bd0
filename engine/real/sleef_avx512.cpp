#include "engine/real/rounding.hpp"
#include "engine/real/sleef_lanes.hpp"

#include <immintrin.h>
#include <sleef.h>

#define LOOKUP sleef_avx512

#define REAL float
#define VECTOR __m512
#define NAME(name, accuracy) Sleef_finz_##name##f16_##accuracy##avx512f
#include "engine/real/sleef_lanes.inc"

#define REAL double
#define VECTOR __m512d
#define NAME(name, accuracy) Sleef_finz_##name##d8_##accuracy##avx512f
#include "engine/real/sleef_lanes.inc"
