#include "engine/antialias/ray_stretches.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/antialias/ray_stretches.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/antialias/least_search-inl.hpp"
#include "engine/antialias/root_search-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

void search_least(const TraceFrame& frame, const TileRays& rays, std::span<RayStretch> stretches,
                  Counters& counters) {
    LeastSearch search;
    for (std::size_t first = 0; first < stretches.size(); first += LeastSearch::capacity) {
        const std::size_t count = std::min(LeastSearch::capacity, stretches.size() - first);
        search.search(frame, rays, stretches.subspan(first, count), counters);
    }
}

void search_roots(const TraceFrame& frame, const TileRays& rays, std::span<RayRoot> roots,
                  std::span<const std::uint32_t> which, Counters& counters) {
    RootSearch search;
    for (const bool several : {false, true}) {
        const std::size_t samples = several ? RootSearch::several_samples : 2;
        std::array<std::uint32_t, RootSearch::capacity> some{};
        std::size_t count = 0;
        const auto search_some = [&] {
            if (count > 0)
                search.search(frame, rays, roots, std::span(some).first(count), samples, counters);
            count = 0;
        };
        for (const std::uint32_t i : which) {
            if (roots[i].several != several) continue;
            some[count++] = i;
            if (count == some.size()) search_some();
        }
        search_some();
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(search_least);
HWY_EXPORT(search_roots);

}  // namespace

void find_least(const TraceFrame& frame, const TileRays& rays, std::span<RayStretch> stretches,
                Counters& counters) {
    HWY_DYNAMIC_DISPATCH(search_least)(frame, rays, stretches, counters);
}

void find_roots(const TraceFrame& frame, const TileRays& rays, std::span<RayRoot> roots,
                Counters& counters) {
    std::vector<std::uint32_t> all(roots.size());
    std::iota(all.begin(), all.end(), 0U);
    find_roots(frame, rays, roots, all, counters);
}

void find_roots(const TraceFrame& frame, const TileRays& rays, std::span<RayRoot> roots,
                std::span<const std::uint32_t> which, Counters& counters) {
    HWY_DYNAMIC_DISPATCH(search_roots)(frame, rays, roots, which, counters);
}

}  // namespace zeroset

#endif
