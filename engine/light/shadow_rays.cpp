#include "engine/kernel/form_cells.hpp"
#include "engine/kernel/form_signs.hpp"
#include "engine/light/shadow_search.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/in_precision.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/light/shadow_rays.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/light/ray_steps-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real>
class RaySearch {
public:
    RaySearch(const ShadowSearch& search, ShadowBits& found, Counters& counters)
        : search_(search),
          found_(found),
          counters_(counters),
          frustum_(search.rays.frustum<Real>(1)),
          rules_{.margin = upper_end(Real{}, search.rays.depth_error()),
                 .finest = static_cast<Real>(search.finest),
                 .bias = static_cast<Real>(search.bias),
                 .is_member = search.is_member} {}

    void search(std::span<const LightRay> rays);

private:
    void load(std::size_t i, const LightRay& ray);
    /// Sets the next cells of the first `count` rays and takes their forms.
    void evaluate(std::size_t count);
    /// Takes the first `count` rays on by these forms, and closes the gaps of those that ended;
    /// returns how many are left.
    std::size_t advance(std::size_t count);
    /// Notes what is found of the ray of a lane.
    void end(std::size_t i, bool is_dark);

    const ShadowSearch& search_;
    ShadowBits& found_;
    Counters& counters_;
    FrustumOf<Real> frustum_;
    RayRules<Real> rules_;
    LightRayBlock<Real> block_;
    FormCells<Real, LightRayBlock<Real>::capacity> cells_;
};

template <class Real>
void RaySearch<Real>::load(std::size_t i, const LightRay& ray) {
    constexpr double first_step = 0.125;  // of all of the ray
    LightRayBlock<Real>& to = block_;
    to.u[i] = static_cast<Real>(ray.u);
    to.v[i] = static_cast<Real>(ray.v);
    to.s[i] = static_cast<Real>(ray.s);
    to.from[i] = -upper_end(Real{}, -ray.from);
    to.to[i] = upper_end(Real{}, ray.to);
    to.step[i] = static_cast<Real>(first_step * (ray.to - ray.from));
    to.pixel[i] = static_cast<RayWord<Real>>(ray.pixel);
    to.marks[i] = (ray.left ? RayMarks::left : 0U) | (ray.is_root ? RayMarks::root : 0U) |
                  (ray.sign == RaySign::Positive ? RayMarks::positive : 0U) |
                  (ray.sign == RaySign::Negative ? RayMarks::negative : 0U);
}

template <class Real>
void RaySearch<Real>::evaluate(std::size_t count) {
    const std::size_t size = padded(count);
    for (std::size_t i = count; i < size; ++i)
        block_.repeat(count - 1, i);
    for (std::size_t i = 0; i < size; i += lanes<Real>)
        place_cells(block_, rules_, i, cells_);
    counters_.form += count;
    const Kernel& kernel = search_.light.kernel;
    const Real* const uniforms = search_.light.scene.uniforms.template boxes<Real>();
    kernel.ray_form(cells_.batch(size, frustum_, uniforms));
    counters_.range += ask_unknown_signs(kernel.template in<Real>().range, frustum_, true, uniforms,
                                         count, cells_);
}

template <class Real>
void RaySearch<Real>::end(std::size_t i, bool is_dark) {
    const std::size_t row = block_.pixel[i] / tile_size;
    const std::uint64_t hit = std::uint64_t{1} << block_.pixel[i] % tile_size;
    const bool proved = (block_.marks[i] & RayMarks::unproved) == 0;
    if (is_dark && proved) return found_.prove_dark(row, hit);
    if (!proved) found_.doubt(row, hit);
    if (is_dark) found_.dark[row] |= hit;
}

template <class Real>
std::size_t RaySearch<Real>::advance(std::size_t count) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; i += lanes<Real>) {
        const LaneBits all = ~LaneBits{0} >> (32 - std::min(lanes<Real>, count - i));
        const RayEnds ends = take_cells(block_, rules_, i, cells_);
        for (LaneBits bits = ends.told & all; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            end(i + lane, (ends.dark >> lane & 1U) != 0);
        }
        kept += block_.keep(i, all & ~ends.ended, kept);
    }
    return kept;
}

template <class Real>
void RaySearch<Real>::search(std::span<const LightRay> rays) {
    std::size_t count = 0;
    while ((count > 0 || !rays.empty()) && !search_.light.stopped()) {
        const std::size_t more = std::min(LightRayBlock<Real>::capacity - count, rays.size());
        for (std::size_t i = 0; i < more; ++i)
            load(count + i, rays[i]);
        rays = rays.subspan(more);
        count += more;
        evaluate(count);
        count = advance(count);
    }
}

void search_all(const ShadowSearch& search, const std::vector<LightRay>& rays, ShadowBits& found,
                Counters& counters) {
    in_precision(search.light, [&](auto real) {
        RaySearch<decltype(real)>(search, found, counters).search(rays);
    });
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(search_all);

}  // namespace

void search_rays(const ShadowSearch& search, const std::vector<LightRay>& rays, ShadowBits& found,
                 Counters& counters) {
    if (!rays.empty()) HWY_DYNAMIC_DISPATCH(search_all)(search, rays, found, counters);
}

}  // namespace zeroset

#endif
