#include "engine/real/processor.hpp"

#include <hwy/targets.h>

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace zeroset {
namespace {

int wanted_of_environment() {
    const char* const text = std::getenv("ZEROSET_WIDEST");  // NOLINT(concurrency-mt-unsafe)
    const std::string_view wanted = text == nullptr ? "" : text;
    return wanted == "16" ? 16 : wanted == "32" ? 32 : 64;
}

/// Holds Highway to the same, before it first chooses.
const bool highway_is_held = [] {
    constexpr std::int64_t avx512 = HWY_AVX3 | HWY_AVX3_DL;
    if (widest_registers_allowed() < 32) {
        hwy::DisableTargets(HWY_AVX2 | avx512);
    } else if (widest_registers_allowed() < 64) {
        hwy::DisableTargets(avx512);
    }
    return true;
}();

}  // namespace

int widest_registers_allowed() {
    static const int bytes = wanted_of_environment();
    return bytes;
}

bool machine_has_fma() { return widest_registers_allowed() >= 32 && __builtin_cpu_supports("fma"); }

bool machine_has_avx2_fma() { return machine_has_fma() && __builtin_cpu_supports("avx2"); }

bool machine_has_avx512() {
    return widest_registers_allowed() >= 64 && machine_has_avx2_fma() &&
           __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}

}  // namespace zeroset
