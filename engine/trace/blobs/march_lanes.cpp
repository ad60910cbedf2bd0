// Rays through soft balls in vectors (engine/trace/blobs/ray_march-inl.hpp): in floats as far as
// these tell, what is left in doubles.

#include "engine/trace/blobs/ray_block.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/blobs/march_lanes.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/blobs/ray_march-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Follows the open rays, as many at once as there are lanes, in numbers of this type.
template <class Real, BlobKind kind>
BallEvaluations march_in(const BallQuestion& question, BallBlock& block) {
    thread_local std::vector<SlotOf<Real>> slots;
    std::array<std::uint8_t, ray_block_rays> open{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < ray_block_rays; ++i) {
        if (block.state[i] == BallRayState::Open) open[count++] = static_cast<std::uint8_t>(i);
    }
    if (count == 0) return 0;
    const MarchBounds<Real> bounds(question);
    BallEvaluations evaluations = 0;
    for (std::size_t first = 0; first < count; first += lanes<Real>) {
        const std::size_t some = std::min(lanes<Real>, count - first);
        const auto places = std::span<const std::uint8_t>(open).subspan(first, some);
        evaluations += RayMarch<Real, kind>(question, block, bounds, places, slots).run();
    }
    return evaluations;
}

template <BlobKind kind>
BallEvaluations march_kind(const BallQuestion& question, BallBlock& block) {
    const BallEvaluations in_float = march_in<float, kind>(question, block);
    return in_float + march_in<double, kind>(question, block);
}

BallEvaluations march_lanes(const BallQuestion& question, BallBlock& block) {
    if (question.kind == BlobKind::Wyvill) return march_kind<BlobKind::Wyvill>(question, block);
    if (question.kind == BlobKind::Metaball) return march_kind<BlobKind::Metaball>(question, block);
    return march_kind<BlobKind::Blinn>(question, block);
}

void list_near_lanes(const BallColumns& columns, std::size_t count, const BlockBeam& beam,
                     std::vector<std::uint32_t>& near) {
    const Tag<float> tag;
    const auto number = [&](double x) { return hn::Set(tag, static_cast<float>(x)); };
    const auto longest = [](double tangent, double radius) {
        const double most = std::abs(tangent) + radius;
        return std::sqrt(1 + most * most);
    };
    const V<float> spare = number(beam.spare);
    near.clear();
    for (std::size_t first = 0; first < count; first += lanes<float>) {
        const V<float> z = hn::LoadU(tag, &columns.z[first]);
        const V<float> support = hn::LoadU(tag, &columns.support[first]);
        const V<float> reach = hn::Add(support, spare);
        const M<float> meets = hn::And(hn::Le(hn::Sub(z, reach), number(beam.to)),
                                       hn::Ge(hn::Add(z, reach), number(beam.from)));
        const auto beside = [&](const V<float>& at, double tangent, double radius) {
            const V<float> middle = hn::MulAdd(number(tangent), z, number(tangent * beam.distance));
            const V<float> half = hn::MulAdd(number(radius), z, number(radius * beam.distance));
            const V<float> most =
                hn::MulAdd(support, number(longest(tangent, radius)), hn::Add(half, spare));
            return hn::Le(hn::Abs(hn::Sub(at, middle)), most);
        };
        const M<float> inside =
            hn::And(beside(hn::LoadU(tag, &columns.x[first]), beam.u, beam.u_radius),
                    beside(hn::LoadU(tag, &columns.y[first]), beam.v, beam.v_radius));
        LaneBits bits = bits_of(tag, hn::And(meets, inside));
        for (; bits != 0; bits &= bits - 1)
            near.push_back(static_cast<std::uint32_t>(first) +
                           static_cast<std::uint32_t>(std::countr_zero(bits)));
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(march_lanes);
HWY_EXPORT(list_near_lanes);

}  // namespace

BallEvaluations march(const BallQuestion& question, BallBlock& block) {
    return HWY_DYNAMIC_DISPATCH(march_lanes)(question, block);
}

void list_near(const BallColumns& columns, std::size_t count, const BlockBeam& beam,
               std::vector<std::uint32_t>& near) {
    HWY_DYNAMIC_DISPATCH(list_near_lanes)(columns, count, beam, near);
}

void BallColumns::fill(std::span<const ViewBall> balls) {
    constexpr std::size_t widest = 16;
    const std::size_t size = (balls.size() + widest - 1) / widest * widest;
    for (std::vector<float>* const column : {&x, &y, &z, &support})
        column->assign(size, -std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        x[i] = static_cast<float>(balls[i].x);
        y[i] = static_cast<float>(balls[i].y);
        z[i] = static_cast<float>(balls[i].z);
        support[i] = static_cast<float>((1 + 0x1p-20) * balls[i].support);
    }
}

}  // namespace zeroset

#endif
