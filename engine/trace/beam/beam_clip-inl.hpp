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

#include <cmath>
#include <limits>

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
        const RayVectors<ClipTag> lines =
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

    static RayVectors<ClipTag> lines_of(const RaysOf<double>& rays, V col, V row) {
        const auto line = [&](double base, double by_col, double by_row) {
            return hn::MulAdd(row, hn::Set(dd, by_row),
                              hn::MulAdd(col, hn::Set(dd, by_col), hn::Set(dd, base)));
        };
        RayVectors<ClipTag> lines;
        for (int k = 0; k < 3; ++k) {
            lines.origin[k] = line(rays.origin[k], rays.origin_by_col[k], rays.origin_by_row[k]);
            lines.direction[k] =
                line(rays.direction[k], rays.direction_by_col[k], rays.direction_by_row[k]);
        }
        return lines;
    }

    InsideSpans<ClipTag> spans_;
};

/// Whether all points of whole pixels, between two depths each, are inside the clip box, or all
/// outside. In a row, or in columns of some rows.
template <class D>
class PixelBoxes {
public:
    using Real = hn::TFromD<D>;
    using V = hn::Vec<D>;
    using M = hn::Mask<D>;

    /// The pixels from `col` on, as RaysOf counts them; `row`: the middle of so many rows.
    HWY_INLINE PixelBoxes(const TileRays& rays, Real col, Real row, V from, V to, int rows = 1)
        : inside_(hn::Ge(from, number(rays.first_depth() + 2.0 * rays.depth_error()))),
          outside_(hn::Lt(hn::Inf(d), hn::Zero(d))) {
        const V cols = hn::Iota(d, col);
        for (int k = 0; k < 3; ++k)
            cut(rays, k, cols, static_cast<double>(row), from, to, rows);
    }
    [[nodiscard]] M inside() const { return inside_; }
    [[nodiscard]] M outside() const { return outside_; }

private:
    static constexpr D d{};

    static HWY_INLINE V number(double value) { return hn::Set(d, static_cast<Real>(value)); }
    /// Takes in the walls across axis k.
    HWY_INLINE void cut(const TileRays& rays, int k, V cols, double row, V from, V to, int rows) {
        const RaysOf<double>& of = rays.double_rays();
        const V origin = hn::MulAdd(cols, number(of.origin_by_col[k]),
                                    number(of.origin[k] + row * of.origin_by_row[k]));
        const V direction = hn::MulAdd(cols, number(of.direction_by_col[k]),
                                       number(of.direction[k] + row * of.direction_by_row[k]));
        // How far the rays of pixels are from their middle's along the axis, twice.
        const auto spread = [&](V s) {
            return hn::Add(
                hn::Abs(hn::MulAdd(s, number(of.direction_by_col[k]), number(of.origin_by_col[k]))),
                hn::Abs(hn::MulAdd(s, number(rows * of.direction_by_row[k]),
                                   number(rows * of.origin_by_row[k]))));
        };
        const V first = hn::MulAdd(from, direction, origin);
        const V last = hn::MulAdd(to, direction, origin);
        const V across = hn::Max(spread(from), spread(to));
        // Roundings, of terms that may be larger than their sum.
        const V depth = hn::Max(hn::Abs(from), hn::Abs(to));
        const V size =
            hn::Add(hn::MulAdd(depth, hn::Abs(direction), number(std::abs(of.origin[k]))),
                    hn::Mul(number(tile_size), across));
        const V error = hn::MulAdd(number(32 * std::numeric_limits<Real>::epsilon()), size,
                                   number(2.0 * rays.depth_error()));
        const V radius = hn::MulAdd(number(0.5), across, error);
        const V lo = hn::Sub(hn::Min(first, last), radius);
        const V hi = hn::Add(hn::Max(first, last), radius);
        const V clip_lo = number(rays.clip().lo[k]);
        const V clip_hi = number(rays.clip().hi[k]);
        inside_ = hn::And(inside_, hn::And(hn::Gt(lo, clip_lo), hn::Lt(hi, clip_hi)));
        outside_ = hn::Or(outside_, hn::Or(hn::Lt(hi, clip_lo), hn::Gt(lo, clip_hi)));
    }

    M inside_, outside_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
