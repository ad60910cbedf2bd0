#include "engine/num/sleef.hpp"

#include "engine/num/rounding.hpp"
#include "engine/num/sleef_lanes.hpp"

#include <bit>
#include <cmath>

namespace zeroset {
namespace {

struct Row {
    int arity;
    double bound_ulp;
};

constexpr Row rows[] = {
#define ZEROSET_SLEEF(id, arity, name, accuracy, bound_ulp) {arity, bound_ulp},
#include "engine/num/sleef_functions.def"
#undef ZEROSET_SLEEF
};

const Row& row(Elementary function) { return rows[static_cast<std::size_t>(function)]; }

}  // namespace

int elementary_arity(Elementary function) { return row(function).arity; }
double elementary_bound_ulp(Elementary function) { return row(function).bound_ulp; }

float elementary(Elementary function, float a, float b) {
    const UpwardRounding upward;  // what the code returns in; then back to the caller's mode
    const void* const code = elementary_code(function, 1);
    if (row(function).arity == 1) return std::bit_cast<float (*)(float)>(code)(a);
    return std::bit_cast<float (*)(float, float)>(code)(a, b);
}

double elementary(Elementary function, double a, double b) {
    const NearestRounding nearest;
    switch (function) {
        case Elementary::Sin: return std::sin(a);
        case Elementary::Cos: return std::cos(a);
        case Elementary::Acos: return std::acos(a);
        case Elementary::Exp: return std::exp(a);
        case Elementary::Log: return std::log(a);
        case Elementary::Atan2: return std::atan2(a, b);
    }
    return std::nan("");
}

// SLEEF's "finz" functions (with fused multiply-add) give the same bits at every width, and so do
// its "cinz" ones (without); the machine decides the family once for all widths.
const void* elementary_code(Elementary function, int lanes) {
    static const bool fma = machine_has_avx2_fma();
    switch (lanes) {
        case 1: return fma ? sleef_fma_1(function) : sleef_plain_1(function);
        case 4: return fma ? sleef_avx2_4(function) : sleef_sse2_4(function);
        case 8: return fma ? sleef_avx2_8(function) : nullptr;
        case 16: return machine_has_avx512() ? sleef_avx512_16(function) : nullptr;
        default: return nullptr;
    }
}

}  // namespace zeroset
