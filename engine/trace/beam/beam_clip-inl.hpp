// Where rays are inside the clip box and the region.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_CLIP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_CLIP_INL
#undef ZEROSET_BEAM_CLIP_INL
#else
#define ZEROSET_BEAM_CLIP_INL
#endif

#include "engine/trace/beam/beam_cells-inl.hpp"
#include "engine/trace/simd/region_clip-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

using ClipTag = hn::CappedTag<double, 4>;
constexpr int clip_lanes = hn::MaxLanes(ClipTag());

/// Where some rays enter and leave the part of the clip box and of the region in front of the eye,
/// as depths.
class ClipDepths {
public:
    ClipDepths(const TileRays& rays, const float* cols, const float* rows)
        : spans_(rays.first_depth(), rays.depth_error()) {
        const RayLines<ClipTag> lines =
            lines_of(rays.double_rays(), load_doubles(dd, cols), load_doubles(dd, rows));
        for (int k = 0; k < 3; ++k) {
            const V inverse = InsideSpans<ClipTag>::inverse_of(lines.direction[k]);
            const V error = hn::Mul(hn::Set(dd, rays.depth_error()), hn::Abs(inverse));
            const V a = hn::Mul(hn::Sub(hn::Set(dd, rays.clip().lo[k]), lines.origin[k]), inverse);
            const V b = hn::Mul(hn::Sub(hn::Set(dd, rays.clip().hi[k]), lines.origin[k]), inverse);
            spans_.enter(hn::Min(a, b), error);
            spans_.leave(hn::Max(a, b), error);
        }
        for (const Section& section : rays.region().sections)
            spans_.keep(section, rays.error_of(section), lines);
        if (const auto& ball = rays.region().ball) spans_.keep(*ball, rays.error_of(*ball), lines);
    }
    /// Which brackets of roots surely are inside.
    template <class Real>
    [[nodiscard]] LaneBits surely_inside(const Real* lo, const Real* hi) const {
        return bits_of(dd, hn::And(hn::Ge(load_doubles(dd, lo), spans_.enter_hi),
                                   hn::Le(load_doubles(dd, hi), spans_.exit_lo)));
    }
    /// Which brackets of roots surely are outside.
    template <class Real>
    [[nodiscard]] LaneBits surely_outside(const Real* lo, const Real* hi) const {
        return bits_of(dd, hn::Or(hn::Lt(load_doubles(dd, hi), spans_.enter_lo),
                                  hn::Gt(load_doubles(dd, lo), spans_.exit_hi)));
    }
    /// Takes away from parts of the rays what is surely outside.
    void narrow(hn::Vec<ClipTag>& from, hn::Vec<ClipTag>& to) const {
        from = hn::Max(from, spans_.enter_lo);
        to = hn::Min(to, spans_.exit_hi);
    }

private:
    static constexpr ClipTag dd{};
    using V = hn::Vec<ClipTag>;

    static RayLines<ClipTag> lines_of(const RaysOf<double>& rays, V col, V row) {
        const auto line = [&](double base, double by_col, double by_row) {
            return hn::MulAdd(row, hn::Set(dd, by_row),
                              hn::MulAdd(col, hn::Set(dd, by_col), hn::Set(dd, base)));
        };
        RayLines<ClipTag> lines;
        for (int k = 0; k < 3; ++k) {
            lines.origin[k] = line(rays.origin[k], rays.origin_by_col[k], rays.origin_by_row[k]);
            lines.direction[k] =
                line(rays.direction[k], rays.direction_by_col[k], rays.direction_by_row[k]);
        }
        return lines;
    }

    InsideSpans<ClipTag> spans_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
