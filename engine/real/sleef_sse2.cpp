#include "engine/real/rounding.hpp"
#include "engine/real/sleef_lanes.hpp"

#include <immintrin.h>
#include <sleef.h>

#define LOOKUP sleef_sse2

#define REAL float
#define VECTOR __m128
#define NAME(name, accuracy) Sleef_cinz_##name##f4_##accuracy##sse2
#include "engine/real/sleef_lanes.inc"

#define REAL double
#define VECTOR __m128d
#define NAME(name, accuracy) Sleef_cinz_##name##d2_##accuracy##sse2
#include "engine/real/sleef_lanes.inc"
