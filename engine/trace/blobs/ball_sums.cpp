// The balls near a cell or a point, one a lane.

#include "engine/trace/blobs/ball_sums.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/blobs/ball_sums.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/blobs/ball_forms-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real>
BallForm form_in(const BallForms& of, const BallBin& bin, const BallCell& cell) {
    switch (of.kind) {
        case BlobKind::Wyvill: return CellSums<Real, BlobKind::Wyvill>(of, bin, cell).form();
        case BlobKind::Metaball: return CellSums<Real, BlobKind::Metaball>(of, bin, cell).form();
        case BlobKind::Blinn: break;
    }
    return CellSums<Real, BlobKind::Blinn>(of, bin, cell).form();
}
BallForm float_form(const BallForms& of, const BallBin& bin, const BallCell& cell) {
    return form_in<float>(of, bin, cell);
}
BallForm double_form(const BallForms& of, const BallBin& bin, const BallCell& cell) {
    return form_in<double>(of, bin, cell);
}

template <BlobKind kind>
BallValue point_value(const BallForms& of, const BallBin& bin, double x, double y, double z) {
    using Vector = V<double>;
    const auto number = [](double a) { return hn::Set(d<double>, a); };
    const double at = z - bin.depth;
    const Vector right = number(x - bin.u * (of.distance + z));
    const Vector up = number(y - bin.v * (of.distance + z));
    const Vector reach = number(blob_facts(kind).reach);
    Vector value = hn::Zero(d<double>);
    Vector slope[3] = {value, value, value};
    const BinColumns<double>& balls = bin.doubles;
    for (std::size_t part = 0; part < bin.parts(); ++part) {
        if (static_cast<double>(bin.from[part]) > at) break;
        if (static_cast<double>(bin.to[part]) < at) continue;
        for (std::size_t i = part * BallBin::widest; i < (part + 1) * BallBin::widest;
             i += lanes<double>) {
            const Vector dz = hn::Sub(number(at), hn::LoadU(d<double>, &balls.z[i]));
            const Vector dx = hn::MulAdd(number(bin.u), dz,
                                         hn::Sub(right, hn::LoadU(d<double>, &balls.x[i])));
            const Vector dy =
                hn::MulAdd(number(bin.v), dz, hn::Sub(up, hn::LoadU(d<double>, &balls.y[i])));
            const Vector per_square = hn::LoadU(d<double>, &balls.per_square[i]);
            const Vector square = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
            const Vector q = hn::Mul(square, per_square);
            const M<double> inside = hn::Lt(q, reach);
            if (hn::AllFalse(d<double>, inside)) continue;
            const auto h = height_at<kind, Rounds::Once>(d<double>, hn::Min(q, reach));
            const Vector strength =
                hn::IfThenElseZero(inside, hn::LoadU(d<double>, &balls.strength[i]));
            value = hn::MulAdd(strength, h.value, value);
            const Vector steep =
                hn::Mul(hn::Mul(hn::Add(strength, strength), per_square), h.slope);
            slope[0] = hn::MulAdd(steep, dx, slope[0]);
            slope[1] = hn::MulAdd(steep, dy, slope[1]);
            slope[2] = hn::MulAdd(steep, dz, slope[2]);
        }
    }
    const auto sum = [](Vector terms) { return hn::GetLane(hn::SumOfLanes(d<double>, terms)); };
    return {.value = sum(value) - of.level, .slope = {sum(slope[0]), sum(slope[1]), sum(slope[2])}};
}

BallValue value_at(const BallForms& of, const BallBin& bin, double x, double y, double z) {
    switch (of.kind) {
        case BlobKind::Wyvill: return point_value<BlobKind::Wyvill>(of, bin, x, y, z);
        case BlobKind::Metaball: return point_value<BlobKind::Metaball>(of, bin, x, y, z);
        case BlobKind::Blinn: break;
    }
    return point_value<BlobKind::Blinn>(of, bin, x, y, z);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(float_form);
HWY_EXPORT(double_form);
HWY_EXPORT(value_at);

}  // namespace

BallForm form_by_floats(const BallForms& of, const BallBin& bin, const BallCell& cell) {
    return HWY_DYNAMIC_DISPATCH(float_form)(of, bin, cell);
}
BallForm form_by_doubles(const BallForms& of, const BallBin& bin, const BallCell& cell) {
    return HWY_DYNAMIC_DISPATCH(double_form)(of, bin, cell);
}
BallValue value_of(const BallForms& of, const BallBin& bin, double x, double y, double z) {
    return HWY_DYNAMIC_DISPATCH(value_at)(of, bin, x, y, z);
}

}  // namespace zeroset

#endif
