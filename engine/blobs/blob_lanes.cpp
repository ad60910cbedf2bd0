// Sums over blobs in vectors of doubles; blob after blob, and the lanes a vector at a time.

#include "engine/blobs/blob_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/blobs/blob_lanes.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/blobs/blob_heights-inl.hpp"
#include "engine/real/lane_carrier-inl.hpp"

#include <hwy/highway.h>

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// h and h' at q within the reach.
using Height = HeightOf<V<double>>;
template <BlobKind kind>
HWY_INLINE Height height_at(V<double> q) {
    return height_at<kind, Rounds::Twice>(d<double>, q);
}

HWY_INLINE V<double> square(V<double> x) { return hn::Mul(x, x); }

/// A blob's numbers in all lanes.
struct BlobVector {
    HWY_INLINE BlobVector(const BlobSet& set, std::size_t at)
        : center{number(set.center(0)[at]), number(set.center(1)[at]), number(set.center(2)[at])},
          per_square(number(set.per_square()[at])),
          strength(number(set.strength()[at])),
          size(number(std::abs(set.strength()[at]))),
          size_per_radius(number(set.size_per_radius()[at])),
          is_hollow(set.strength()[at] < 0) {}

    V<double> center[3];  // NOLINT(modernize-use-default-member-init): goes by the arguments
    V<double> per_square, strength, size, size_per_radius;
    bool is_hollow;
};

/// Calls visit(blob) for all of a run.
HWY_INLINE void each_blob(const BlobRun& run, const auto& visit) {
    for (const BlobRange& range : run.ranges) {
        for (std::size_t n = range.first; n < range.last; ++n)
            visit(BlobVector(run.set, n));
    }
}

template <BlobKind kind>
void add_to_points(const BlobRun& run, BlobPoints& points) {
    const V<double> reach = number(blob_facts(kind).reach);
    for (std::size_t at = 0; at < points.count; at += lanes<double>) {
        const V<double> place[3] = {hn::Load(d<double>, points.at[0] + at),
                                    hn::Load(d<double>, points.at[1] + at),
                                    hn::Load(d<double>, points.at[2] + at)};
        V<double> value = hn::Load(d<double>, points.value + at);
        V<double> slope[3] = {hn::Load(d<double>, points.slope[0] + at),
                              hn::Load(d<double>, points.slope[1] + at),
                              hn::Load(d<double>, points.slope[2] + at)};
        each_blob(run, [&](const BlobVector& blob) {
            V<double> from[3];
            for (std::size_t i = 0; i < 3; ++i)
                from[i] = hn::Sub(place[i], blob.center[i]);
            const V<double> squares =
                hn::Add(hn::Add(square(from[0]), square(from[1])), square(from[2]));
            const V<double> q = hn::Mul(squares, blob.per_square);
            const M<double> inside = hn::Lt(q, reach);
            if (hn::AllFalse(d<double>, inside)) return;
            const Height h = height_at<kind>(minimum(q, reach));
            value = hn::Add(value, hn::IfThenElseZero(inside, hn::Mul(blob.strength, h.value)));
            const V<double> steep =
                hn::Mul(hn::Mul(number(2), hn::Mul(blob.strength, blob.per_square)), h.slope);
            for (std::size_t i = 0; i < 3; ++i) {
                slope[i] = hn::Add(slope[i], hn::IfThenElseZero(inside, hn::Mul(steep, from[i])));
            }
        });
        hn::Store(value, d<double>, points.value + at);
        for (std::size_t i = 0; i < 3; ++i)
            hn::Store(slope[i], d<double>, points.slope[i] + at);
    }
}

/// A vector of boxes, and the sums over blobs in them.
template <BlobKind kind>
class BoxVector {
public:
    HWY_INLINE BoxVector(BlobBoxes& boxes, std::size_t at) : boxes_(boxes), at_(at) {
        for_each([&](V<double>& sum, double* numbers) { sum = hn::Load(d<double>, numbers + at); });
        for (std::size_t i = 0; i < 3; ++i) {
            lo_[i] = hn::Load(d<double>, boxes.lo[i] + at);
            hi_[i] = hn::Load(d<double>, boxes.hi[i] + at);
        }
    }
    HWY_INLINE void store() {
        for_each([&](const V<double>& sum, double* numbers) {
            hn::Store(sum, d<double>, numbers + at_);
        });
    }
    HWY_INLINE void add(const BlobVector& blob) {
        const V<double> reach = number(blob_facts(kind).reach);
        const V<double> zero = hn::Zero(d<double>);
        V<double> lo[3];
        V<double> hi[3];
        V<double> near = zero;
        V<double> far = zero;
        for (std::size_t i = 0; i < 3; ++i) {
            lo[i] = hn::Sub(lo_[i], blob.center[i]);
            hi[i] = hn::Sub(hi_[i], blob.center[i]);
            near = hn::Add(near, square(maximum(maximum(lo[i], hn::Neg(hi[i])), zero)));
            far = hn::Add(far, square(maximum(hn::Neg(lo[i]), hi[i])));
        }
        const V<double> nearest = hn::Mul(near, blob.per_square);
        const M<double> reached = hn::Lt(nearest, reach);
        if (hn::AllFalse(d<double>, reached)) return;
        const V<double> farthest = hn::Mul(far, blob.per_square);
        const M<double> inside = hn::Lt(farthest, reach);
        const Height top = height_at<kind>(minimum(nearest, reach));
        const Height end = height_at<kind>(minimum(farthest, reach));
        const V<double> low = hn::IfThenElseZero(inside, end.value);
        const V<double> slope_end = hn::IfThenElseZero(inside, end.slope);
        const auto add_to = [&](V<double>& sum, V<double> term) {
            sum = hn::Add(sum, hn::IfThenElseZero(reached, term));
        };
        add_to(value_lo_, hn::Mul(blob.strength, blob.is_hollow ? top.value : low));
        add_to(value_hi_, hn::Mul(blob.strength, blob.is_hollow ? low : top.value));
        const V<double> steep = hn::Mul(number(2), hn::Mul(blob.strength, blob.per_square));
        for (std::size_t i = 0; i < 3; ++i) {
            // h' is not above 0, and rises with q.
            const V<double> least =
                hn::Mul(hi[i], hn::IfThenElse(hn::Gt(hi[i], zero), top.slope, slope_end));
            const V<double> greatest =
                hn::Mul(lo[i], hn::IfThenElse(hn::Lt(lo[i], zero), top.slope, slope_end));
            add_to(slope_lo_[i], hn::Mul(steep, blob.is_hollow ? greatest : least));
            add_to(slope_hi_[i], hn::Mul(steep, blob.is_hollow ? least : greatest));
        }
        add_to(reached_, number(1));
        add_to(size_, blob.size);
        add_to(size_per_radius_, blob.size_per_radius);
    }

private:
    HWY_INLINE void for_each(const auto& visit) {
        visit(value_lo_, boxes_.value_lo);
        visit(value_hi_, boxes_.value_hi);
        for (std::size_t i = 0; i < 3; ++i) {
            visit(slope_lo_[i], boxes_.slope_lo[i]);
            visit(slope_hi_[i], boxes_.slope_hi[i]);
        }
        visit(reached_, boxes_.reached);
        visit(size_, boxes_.size);
        visit(size_per_radius_, boxes_.size_per_radius);
    }

    BlobBoxes& boxes_;
    std::size_t at_;
    V<double> lo_[3], hi_[3];
    V<double> value_lo_, value_hi_, slope_lo_[3], slope_hi_[3];
    V<double> reached_, size_, size_per_radius_;
};

template <BlobKind kind>
void add_to_boxes(const BlobRun& run, BlobBoxes& boxes) {
    for (std::size_t at = 0; at < boxes.count; at += lanes<double>) {
        BoxVector<kind> box(boxes, at);
        each_blob(run, [&](const BlobVector& blob) { box.add(blob); });
        box.store();
    }
}

void add_points(const BlobRun& run, BlobPoints& points) {
    if (run.kind == BlobKind::Wyvill) return add_to_points<BlobKind::Wyvill>(run, points);
    if (run.kind == BlobKind::Metaball) return add_to_points<BlobKind::Metaball>(run, points);
    add_to_points<BlobKind::Blinn>(run, points);
}

void add_boxes(const BlobRun& run, BlobBoxes& boxes) {
    if (run.kind == BlobKind::Wyvill) return add_to_boxes<BlobKind::Wyvill>(run, boxes);
    if (run.kind == BlobKind::Metaball) return add_to_boxes<BlobKind::Metaball>(run, boxes);
    add_to_boxes<BlobKind::Blinn>(run, boxes);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(add_points);
HWY_EXPORT(add_boxes);

}  // namespace

void add_blobs(const BlobRun& run, BlobPoints& points) {
    HWY_DYNAMIC_DISPATCH(add_points)(run, points);
}
void add_blobs(const BlobRun& run, BlobBoxes& boxes) {
    HWY_DYNAMIC_DISPATCH(add_boxes)(run, boxes);
}

}  // namespace zeroset

#endif
