// Sums over the balls near cells or points, ball after ball; a cell or point a lane.

#include "engine/trace/blobs/ball_sums.hpp"

#include "engine/real/unbounded.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/blobs/ball_sums.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/blobs/ball_forms-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real, BlobKind kind>
void forms_of_kind(const BallForms& of, const BallBin& bin, const BallCells& cells,
                   BallForm* forms) {
    for (std::size_t first = 0; first < cells.count; first += lanes<Real>)
        CellSums<Real, kind>(of, bin, cells, first).write(forms);
}
template <class Real>
void forms_in(const BallForms& of, const BallBin& bin, const BallCells& cells, BallForm* forms) {
    switch (of.kind) {
        case BlobKind::Wyvill: return forms_of_kind<Real, BlobKind::Wyvill>(of, bin, cells, forms);
        case BlobKind::Metaball:
            return forms_of_kind<Real, BlobKind::Metaball>(of, bin, cells, forms);
        case BlobKind::Blinn: break;
    }
    forms_of_kind<Real, BlobKind::Blinn>(of, bin, cells, forms);
}
void float_forms(const BallForms& of, const BallBin& bin, const BallCells& cells, BallForm* forms) {
    forms_in<float>(of, bin, cells, forms);
}
void double_forms(const BallForms& of, const BallBin& bin, const BallCells& cells,
                  BallForm* forms) {
    forms_in<double>(of, bin, cells, forms);
}

template <BlobKind kind>
void values_at(const BallForms& of, const BallBin& bin, BallPoints& points, std::size_t first) {
    const std::size_t some = std::min(lanes<double>, points.count - first);
    // A lane that has no number takes no balls from the others.
    double nearest = unbounded;
    double farthest = -unbounded;
    for (std::size_t i = first; i < first + some; ++i) {
        nearest = std::min(nearest, points.z[i]);
        farthest = std::max(farthest, points.z[i]);
    }
    // Load the points, from the middle ray of the bin on.
    const V<double> z = hn::LoadU(d<double>, &points.z[first]);
    const V<double> at = hn::Sub(z, number(bin.depth));
    const V<double> w = hn::Add(z, number(of.distance));
    const V<double> right = hn::NegMulAdd(number(bin.u), w, hn::LoadU(d<double>, &points.x[first]));
    const V<double> up = hn::NegMulAdd(number(bin.v), w, hn::LoadU(d<double>, &points.y[first]));
    const V<double> reach = number(blob_facts(kind).reach);
    V<double> value = hn::Zero(d<double>);
    V<double> slope[3] = {value, value, value};
    const BinColumns<double>& balls = bin.doubles;
    // Add the heights and slopes of the balls that may reach the points.
    each_ball_between(bin, nearest - bin.depth, farthest - bin.depth, [&](std::size_t i) {
        const V<double> dz = hn::Sub(at, number(balls.z[i]));
        const V<double> dx = hn::MulAdd(number(bin.u), dz, hn::Sub(right, number(balls.x[i])));
        const V<double> dy = hn::MulAdd(number(bin.v), dz, hn::Sub(up, number(balls.y[i])));
        const V<double> per_square = number(balls.per_square[i]);
        const V<double> square = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
        const V<double> q = hn::Mul(square, per_square);
        const M<double> inside = hn::Lt(q, reach);
        if (hn::AllFalse(d<double>, inside)) return;
        const auto h = height_at<kind, Rounds::Once>(d<double>, hn::Min(q, reach));
        const V<double> strength = hn::IfThenElseZero(inside, number(balls.strength[i]));
        value = hn::MulAdd(strength, h.value, value);
        const V<double> steep = hn::Mul(hn::Mul(hn::Add(strength, strength), per_square), h.slope);
        slope[0] = hn::MulAdd(steep, dx, slope[0]);
        slope[1] = hn::MulAdd(steep, dy, slope[1]);
        slope[2] = hn::MulAdd(steep, dz, slope[2]);
    });
    hn::StoreU(hn::Sub(value, number(of.level)), d<double>, &points.value[first]);
    for (std::size_t k = 0; k < 3; ++k)
        hn::StoreU(slope[k], d<double>, &points.slope[k][first]);
}
template <BlobKind kind>
void values_of_kind(const BallForms& of, const BallBin& bin, BallPoints& points) {
    for (std::size_t first = 0; first < points.count; first += lanes<double>)
        values_at<kind>(of, bin, points, first);
}
void all_values(const BallForms& of, const BallBin& bin, BallPoints& points) {
    switch (of.kind) {
        case BlobKind::Wyvill: return values_of_kind<BlobKind::Wyvill>(of, bin, points);
        case BlobKind::Metaball: return values_of_kind<BlobKind::Metaball>(of, bin, points);
        case BlobKind::Blinn: break;
    }
    values_of_kind<BlobKind::Blinn>(of, bin, points);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(float_forms);
HWY_EXPORT(double_forms);
HWY_EXPORT(all_values);

}  // namespace

BallForms ball_forms(const BallBins& bins, const BlobSurface& surface) {
    const TileRays& rays = bins.rays();
    const Blobs& blobs = *surface.blobs;
    const double u_most = std::max(std::abs(rays.u(-1)), std::abs(rays.u(tile_size)));
    const double v_most = std::max(std::abs(rays.v(-1)), std::abs(rays.v(tile_size)));
    return {.kind = blobs.kind(),
            .level = surface.level,
            .tail = surface.tail(),
            .slope_tail = (1 + u_most + v_most) * blob_facts(blobs.kind()).tail *
                          blobs.set().total().per_radius,
            .distance = rays.distance(),
            .place_error = 16 * rays.depth_error()};
}

void forms_by_floats(const BallForms& of, const BallBin& bin, const BallCells& cells,
                     BallForm* forms) {
    HWY_DYNAMIC_DISPATCH(float_forms)(of, bin, cells, forms);
}
void forms_by_doubles(const BallForms& of, const BallBin& bin, const BallCells& cells,
                      BallForm* forms) {
    HWY_DYNAMIC_DISPATCH(double_forms)(of, bin, cells, forms);
}
void find_values(const BallForms& of, const BallBin& bin, BallPoints& points) {
    HWY_DYNAMIC_DISPATCH(all_values)(of, bin, points);
}

}  // namespace zeroset

#endif
