#include "engine/real/rounding.hpp"
#include "engine/real/sleef_lanes.hpp"

#include <immintrin.h>
#include <sleef.h>

#define LOOKUP sleef_avx2_256

#define REAL float
#define VECTOR __m256
#define NAME(name, accuracy) Sleef_finz_##name##f8_##accuracy##avx2
#include "engine/real/sleef_lanes.inc"

#define REAL double
#define VECTOR __m256d
#define NAME(name, accuracy) Sleef_finz_##name##d4_##accuracy##avx2
#include "engine/real/sleef_lanes.inc"
