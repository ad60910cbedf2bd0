#include "engine/num/rounding.hpp"
#include "engine/num/sleef_lanes.hpp"

#include <immintrin.h>
#include <sleef.h>

#define LOOKUP sleef_fma_1
#define VECTOR float
#define NAME(name, accuracy) Sleef_finz_##name##f1_##accuracy##purecfma
#include "engine/num/sleef_lanes.inc"
