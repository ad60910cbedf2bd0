// Single rays of a tile: where cells of pixels tell too little.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_TILE_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_TILE_RAYS_INL
#undef ZEROSET_BEAM_TILE_RAYS_INL
#else
#define ZEROSET_BEAM_TILE_RAYS_INL
#endif

#include "engine/real/scalar.hpp"
#include "engine/trace/beam/beam_clip-inl.hpp"
#include "engine/trace/beam/beam_cuts-inl.hpp"
#include "engine/trace/beam/beam_leftovers-inl.hpp"
#include "engine/trace/beam/beam_tile-inl.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real>
void BeamTile<Real>::march_pixels(std::size_t cell, int pixels, const Kernel* kernel) {
    const Cells<Real>& cells = tree_.cells();
    const Forms<Real>& f = cells.forms;
    const PixelForm form = pixel_form(cell, pixels);
    const Real kt = f.k[2][cell];
    const Real s = cells.places.s[cell];
    const Real s_radius = cells.places.s_radius[cell];
    // Where the linear part vanishes, and how far from there roots may be.
    const Real error = f.e[cell] + static_cast<Real>(0x1p-10 * tile_size) *
                                       (std::abs(form.ku) + std::abs(form.kv));
    const Real rounding = 8 * std::numeric_limits<Real>::epsilon() * (std::abs(s) + s_radius);
    const bool steep = std::abs(kt) > 0;
    const Real scale = steep ? s_radius / kt : 0;
    const Real radius =
        steep ? error * std::abs(scale) + rounding : std::numeric_limits<Real>::infinity();
    const LinearCell linear{cell, radius, form.ku * scale};
    const CellTile tile = cells.tile[cell];
    if (nearest_.cover.wanted()) leave_pixels(linear, form, pixels);
    // Bracket the roots on all rays, a vector at a time.
    alignas(64) Real froms[least_pixels * least_pixels], tos[least_pixels * least_pixels];
    LaneBits bits = 0;
    for (int row = 0; row < pixels && tile.row() + row < tile_.rows; ++row) {
        const Real middle = s - (form.first - form.kv * static_cast<Real>(row)) * scale;
        for (int col = 0; col < pixels; col += clip_lanes) {
            const int i = row * least_pixels + col;
            const Real at_col = middle - static_cast<Real>(col) * linear.by_col;
            bits |= store_brackets(linear, col, row, at_col, froms + i, tos + i) << i;
        }
    }
    // Hand over the rays that may have one.
    for (; bits != 0; bits &= bits - 1) {
        const auto i = static_cast<unsigned>(std::countr_zero(bits));
        const unsigned pixel = tile.pixel + i / least_pixels * tile_size + i % least_pixels;
        marcher_.push({.pixel = pixel,
                       .inside = tile.inside != 0,
                       .from = froms[i],
                       .to = tos[i],
                       .step = tos[i] - froms[i],
                       .kernel = kernel});
    }
}

template <class Real>
void BeamTile<Real>::leave_pixels(const LinearCell& linear, const PixelForm& form, int pixels) {
    const Cells<Real>& cells = tree_.cells();
    const CellTile tile = cells.tile[linear.cell];
    const Real kt = cells.forms.k[2][linear.cell];
    const Real per_kt = std::abs(kt) > 0 ? cells.places.s_radius[linear.cell] / kt : 0;
    constexpr hn::CappedTag<Real, least_pixels> tag;
    const auto from = hn::Set(tag, cells.from[linear.cell]);
    const auto to = hn::Set(tag, cells.to[linear.cell]);
    // Rays are half a pixel from the centres at most.
    const Real radius = linear.radius + static_cast<Real>(0.5) * std::abs(per_kt) *
                                            (std::abs(form.ku) + std::abs(form.kv));
    const auto reach = hn::Set(tag, radius);
    for (int row = 0; row < pixels && tile.row() + row < tile_.rows; ++row) {
        const auto pixel = static_cast<std::size_t>((tile.row() + row) * tile_size + tile.col());
        const Real first =
            cells.places.s[linear.cell] - form.at(0, static_cast<Real>(row)) * per_kt;
        for (int col = 0; col < pixels; col += static_cast<int>(hn::MaxLanes(tag))) {
            const auto middle = hn::NegMulAdd(hn::Iota(tag, static_cast<Real>(col)),
                                              hn::Set(tag, form.ku * per_kt), hn::Set(tag, first));
            const auto lo = hn::Sub(middle, reach);
            const auto hi = hn::Add(middle, reach);
            // All of the cell where that is not a number.
            const auto beside = hn::Or(hn::Gt(lo, to), hn::Lt(hi, from));
            const auto there = static_cast<std::size_t>(std::max(tile_.cols - tile.col() - col, 0));
            const auto some = hn::AndNot(beside, hn::FirstN(tag, there));
            if (hn::AllFalse(tag, some)) continue;
            nearest_.cover.leave(tag, pixel + static_cast<std::size_t>(col),
                                 hn::IfThenElse(hn::Gt(lo, from), lo, from),
                                 hn::IfThenElse(hn::Lt(hi, to), hi, to), some);
        }
    }
}

template <class Real>
LaneBits BeamTile<Real>::store_brackets(const LinearCell& linear, int first_col, int row,
                                        Real middle, Real* froms, Real* tos) const {
    constexpr hn::Rebind<Real, ClipTag> tag;
    const Cells<Real>& cells = tree_.cells();
    const CellTile tile = cells.tile[linear.cell];
    const int col = tile.col() + first_col;
    const auto pixel = static_cast<std::size_t>((tile.row() + row) * tile_size + col);
    const auto radius = hn::Set(tag, linear.radius);
    const auto middles =
        hn::NegMulAdd(hn::Iota(tag, Real{0}), hn::Set(tag, linear.by_col), hn::Set(tag, middle));
    // Keep to the cell, and to its ends where NaN.
    const auto lo = hn::Sub(middles, radius);
    const auto hi = hn::Add(middles, radius);
    const auto cell_from = hn::Set(tag, cells.from[linear.cell]);
    const auto cell_to = hn::Set(tag, cells.to[linear.cell]);
    hn::Store(hn::IfThenElse(hn::Gt(lo, cell_from), lo, cell_from), tag, froms);
    hn::Store(hn::IfThenElse(hn::Lt(hi, cell_to), hi, cell_to), tag, tos);
    if (tile.inside == 0) clip(col, tile.row() + row, froms, tos);
    // Leave rays without a bracket, behind a root, or beside the image.
    const auto from = hn::Load(tag, froms);
    const auto found = hn::LoadU(tag, &nearest_.s[pixel]);
    const auto wanted = hn::And(hn::Le(from, hn::Load(tag, tos)), hn::Le(from, found));
    const auto there = static_cast<std::size_t>(std::max(tile_.cols - col, 0));
    return bits_of(tag, hn::And(wanted, hn::FirstN(tag, there)));
}

template <class Real>
void BeamTile<Real>::clip(int col, int row, Real* froms, Real* tos) const {
    constexpr ClipTag tag;
    alignas(64) float cols[clip_lanes], rows[clip_lanes];
    for (int lane = 0; lane < clip_lanes; ++lane) {
        cols[lane] = from_middle(col + lane);
        rows[lane] = from_middle(row);
    }
    auto from = load_doubles(tag, froms);
    auto to = load_doubles(tag, tos);
    ClipDepths(rays_, cols, rows).narrow(from, to);
    alignas(64) double narrow_from[clip_lanes], narrow_to[clip_lanes];
    hn::Store(from, tag, narrow_from);
    hn::Store(to, tag, narrow_to);
    for (int lane = 0; lane < clip_lanes; ++lane) {
        froms[lane] = -upper_end(Real{}, -narrow_from[lane]);
        tos[lane] = upper_end(Real{}, narrow_to[lane]);
    }
}

template <class Real>
void BeamTile<Real>::march_rays() {
    // March through what Newton's method left open, too.
    roots_.solve();
    for (const RootBracket& bracket : roots_.take_open()) {
        const Real from = -upper_end(Real{}, -bracket.from);
        const Real to = upper_end(Real{}, bracket.to);
        marcher_.push({.pixel = bracket.pixel,
                       .inside = bracket.inside,
                       .from = from,
                       .to = to,
                       .step = to - from,
                       .kernel = bracket.kernel});
    }
    // Search in this type down to some hundred of its units, then in double.
    const double rough = std::max(rays_.tolerance(), 256 * tree_.s_most() * unit);
    const auto finest = static_cast<Real>(rough);
    const auto hand_over = [&](const RaySegment<Real>& segment, Real end, bool) {
        // Where all of a ray is undecided the search in double ends with its first part.
        const bool rest = handed_over_.are(segment.pixel, 32);
        const auto from = static_cast<double>(segment.from);
        const auto to = static_cast<double>(segment.to);
        fine_marcher_.push({.pixel = segment.pixel,
                            .inside = segment.inside,
                            .from = from,
                            .to = rest ? static_cast<double>(end) : to,
                            .step = to - from,
                            .kernel = segment.kernel});
        return !rest;
    };
    marcher_.march({finest, tree_.margin(), false}, hand_over);
    const MarchSettings<double> fine{.finest = rays_.tolerance(),
                                     .margin = 0.25 * rays_.tolerance(),
                                     .certifies = true,
                                     .asked = asked_};
    const auto stop = [&](const RaySegment<double>& segment, double, bool continuous) {
        if (!continuous) {
            mark_unsettled(segment.pixel, segment.from);
            // A ray of which so much is unsettled stays so, whatever is behind.
            return !unsettled_.are(segment.pixel, 128);
        }
        nearest_.add_pending(segment.pixel, 0.5 * segment.from + 0.5 * segment.to,
                             Certificate::Undecided, Trend::Unknown);
        return false;
    };
    fine_marcher_.march(fine, stop);
    fine_marcher_.settle(roots_.take_doubts(), fine, stop);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
