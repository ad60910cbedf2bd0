#include "engine/real/rounding.hpp"
#include "engine/real/sleef_lanes.hpp"

#include <immintrin.h>
#include <sleef.h>

#define LOOKUP sleef_fma

#define REAL float
#define VECTOR float
#define NAME(name, accuracy) Sleef_finz_##name##f1_##accuracy##purecfma
#include "engine/real/sleef_lanes.inc"

#define REAL double
#define VECTOR double
#define NAME(name, accuracy) Sleef_finz_##name##d1_##accuracy##purecfma
#include "engine/real/sleef_lanes.inc"
