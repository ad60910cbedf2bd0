// FormWithin, place_of and is_beside of the parts of a node, a part in each lane.

#include "engine/trace/patch/seen_parts.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/patch/seen_parts.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/patch/patch_zeros-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A vector in the world, or in the axes of a view.
struct Triple {
    V<double> at[3];
};

class PartsInView {
public:
    PartsInView(const PartForms& forms, const PartWindow& window, SeenParts& seen)
        : forms_(forms), window_(window), seen_(seen) {}

    /// The lanes of the parts from `first` on that may be met.
    HWY_INLINE M<double> see(std::size_t first) {
        const Triple c = load(forms_.c, first);
        const Triple ku = load(forms_.ku, first);
        const Triple kv = load(forms_.kv, first);
        const Triple e = load(forms_.e, first);
        const SightAxes& axes = window_.axes;
        Triple offset;
        V<double> most = number(0.0);
        M<double> out = hn::Ne(most, most);
        // Mark parts outside of the clip box.
        for (int k = 0; k < 3; ++k) {
            const V<double> spread =
                hn::Add(hn::Add(hn::Abs(ku.at[k]), hn::Abs(kv.at[k])), e.at[k]);
            const double lo = window_.clip.lo[k];
            const double hi = window_.clip.hi[k];
            // More than rounding may move the ends of a clip box.
            const double spare = 0x1p-40 * (std::abs(lo) + std::abs(hi));
            out = hn::Or(out, hn::Gt(hn::Sub(c.at[k], spread), number(hi + spare)));
            out = hn::Or(out, hn::Lt(hn::Add(c.at[k], spread), number(lo - spare)));
            offset.at[k] = hn::Sub(c.at[k], number(axes.base[k]));
            most = hn::Max(most, hn::Add(hn::Abs(offset.at[k]), spread));
        }
        // Turn the forms into the axes of the view, and store them.
        const V<double> lost = hn::MulAdd(most, number(rounding), number(axes.error));
        const Triple place = turned(offset);
        const Triple kp = turned(ku);
        const Triple kq = turned(kv);
        Triple error = turned_size(e);
        for (V<double>& of : error.at)
            of = hn::Add(of, lost);
        hn::StoreU(lost, d<double>, seen_.value_error.data() + first);
        store(place, seen_.c, first);
        store(kp, seen_.kp, first);
        store(kq, seen_.kq, first);
        store(error, seen_.e, first);
        // Mark parts outside of the depths.
        const V<double> radius =
            hn::Add(hn::Add(hn::Abs(kp.at[2]), hn::Abs(kq.at[2])), error.at[2]);
        out = hn::Or(out, hn::Gt(hn::Sub(place.at[2], radius), number(window_.depths.far)));
        out = hn::Or(out, hn::Lt(hn::Add(place.at[2], radius), number(window_.depths.near)));
        // Mark parts beside the planes through the eye that bound the rays.
        const auto beside = [&](double sign, int axis, double edge) HWY_ATTR {
            const auto across = [&](const Triple& by) HWY_ATTR {
                return hn::NegMulAdd(number(edge), by.at[2], by.at[axis]);
            };
            const V<double> spread =
                hn::Add(hn::Add(hn::Abs(across(kp)), hn::Abs(across(kq))),
                        hn::MulAdd(number(std::abs(edge)), error.at[2], error.at[axis]));
            const V<double> middle = hn::Sub(hn::Sub(place.at[axis], number(edge * axes.distance)),
                                             hn::Mul(number(edge), place.at[2]));
            return hn::Gt(hn::Mul(number(sign), middle), hn::Mul(spread, number(1.0 + 0x1p-40)));
        };
        const RayBounds& rays = window_.rays;
        out = hn::Or(out, hn::Or(beside(-1.0, 0, rays.u_lo), beside(1.0, 0, rays.u_hi)));
        out = hn::Or(out, hn::Or(beside(-1.0, 1, rays.v_lo), beside(1.0, 1, rays.v_hi)));
        return hn::Not(out);
    }

private:
    using Numbers = SeenParts::Numbers;

    static HWY_INLINE Triple load(const Numbers& numbers, std::size_t first) {
        Triple all;
        for (std::size_t k = 0; k < 3; ++k)
            all.at[k] = hn::LoadU(d<double>, numbers[k].data() + first);
        return all;
    }
    static HWY_INLINE void store(const Triple& all, Numbers& numbers, std::size_t first) {
        for (std::size_t k = 0; k < 3; ++k)
            hn::StoreU(all.at[k], d<double>, numbers[k].data() + first);
    }
    [[nodiscard]] HWY_INLINE Triple turned(const Triple& way) const {
        const SightAxes& axes = window_.axes;
        Triple all;
        int k = 0;
        for (const glm::dvec3* const axis : {&axes.right, &axes.up, &axes.forward}) {
            all.at[k++] = hn::MulAdd(
                number(axis->z), way.at[2],
                hn::MulAdd(number(axis->y), way.at[1], hn::Mul(number(axis->x), way.at[0])));
        }
        return all;
    }
    [[nodiscard]] HWY_INLINE Triple turned_size(const Triple& size) const {
        const SightAxes& axes = window_.axes;
        Triple all;
        int k = 0;
        for (const glm::dvec3* const axis : {&axes.right, &axes.up, &axes.forward}) {
            all.at[k++] = hn::MulAdd(number(std::abs(axis->z)), size.at[2],
                                     hn::MulAdd(number(std::abs(axis->y)), size.at[1],
                                                hn::Mul(number(std::abs(axis->x)), size.at[0])));
        }
        return all;
    }

    const PartForms& forms_;
    const PartWindow& window_;
    SeenParts& seen_;
};

std::uint32_t see_all(const PartForms& forms, const PartWindow& window, SeenParts& seen) {
    PartsInView parts(forms, window, seen);
    std::uint32_t bits = 0;
    // Lanes behind the last known part are not of use.
    for (std::size_t first = 0; forms.known >> first != 0; first += lanes<double>)
        bits |= bits_of(d<double>, parts.see(first)) << first;
    return bits & forms.known;
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {

HWY_EXPORT(see_all);

std::uint32_t see_parts(const PartForms& forms, const PartWindow& window, SeenParts& seen) {
    return HWY_DYNAMIC_DISPATCH(see_all)(forms, window, seen);
}

}  // namespace zeroset

#endif
