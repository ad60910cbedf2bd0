// Marks whole pixels by leaves, and those that one smooth sheet covers.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_LEAF_COVER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_LEAF_COVER_INL
#undef ZEROSET_BEAM_LEAF_COVER_INL
#else
#define ZEROSET_BEAM_LEAF_COVER_INL
#endif

#include "engine/trace/beam/beam_leaf-inl.hpp"
#include "engine/trace/tile_blocks.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real, int pixels>
template <bool first_of_run>
void LeafSolver<Real, pixels>::add_cover(const Leaf<Real>& leaf) {
    const ZeroBand sheet(leaf, static_cast<Real>(0.5));  // rays are half a pixel aside at most
    for (int row = 0; row < pixels; ++row) {
        for (int col = 0; col < pixels; col += lanes) {
            const int i = row * pixels + col;
            const V middle = sheet.middle(col, row);
            const V lo = hn::Max(hn::Sub(middle, sheet.radius), sheet.from);
            const V hi = hn::Min(hn::Add(middle, sheet.radius), sheet.to);
            // The brackets of a run's leaves touch where a sheet goes from one to the next. A leaf
            // behind all roots adds its begin, one before them its end: so the joined bracket
            // keeps clear of the run's ends only where f's signs there are known.
            const M not_behind = hn::Le(lo, sheet.to);
            const M not_before = hn::Ge(hi, sheet.from);
            const V nowhere = hn::Inf(d);
            const V before_from = first_of_run ? nowhere : hn::Load(d, cover_from_ + i);
            const V before_to = first_of_run ? hn::Neg(nowhere) : hn::Load(d, cover_to_ + i);
            hn::Store(hn::IfThenElse(not_behind, hn::Min(before_from, lo), before_from), d,
                      cover_from_ + i);
            hn::Store(hn::IfThenElse(not_before, hn::Max(before_to, hi), before_to), d,
                      cover_to_ + i);
        }
    }
}

template <class Real, int pixels>
auto LeafSolver<Real, pixels>::places(int col, int rows) const -> Places {
    if (run_->inside) return {.inside = hn::FirstN(d, lanes), .outside = hn::FirstN(d, 0)};
    V first = hn::Inf(d);
    V last = hn::Neg(hn::Inf(d));
    M any = hn::FirstN(d, 0);
    for (int row = 0; row < rows; ++row) {
        const V from = hn::Load(d, cover_from_ + row * pixels + col);
        const V to = hn::Load(d, cover_to_ + row * pixels + col);
        const M some = hn::Le(from, to);
        first = hn::IfThenElse(some, hn::Min(first, from), first);
        last = hn::IfThenElse(some, hn::Max(last, to), last);
        any = hn::Or(any, some);
    }
    const Real middle = from_middle(run_->row) + 0.5F * static_cast<float>(rows - 1);
    const PixelBoxes<D> boxes(rays_, from_middle(run_->col + col), middle, first, last, rows);
    return {.inside = hn::Or(hn::Not(any), boxes.inside()),
            .outside = hn::Or(hn::Not(any), boxes.outside())};
}

template <class Real, int pixels>
auto LeafSolver<Real, pixels>::mark_columns(int first_col, int rows, bool is_first) -> Marked {
    const Places all = places(first_col, rows);
    if (hn::AllTrue(d, all.outside)) return {};
    const bool at_walls = !hn::AllTrue(d, all.inside);
    const bool is_known = run_->inside || rays_.region().is_whole();
    const bool may_cover = is_known && !run_->kinked && !run_->turns;
    const V run_from = hn::Set(d, may_cover ? run_->from : std::numeric_limits<Real>::infinity());
    const V run_to = hn::Set(d, run_->to);
    M any = hn::FirstN(d, 0);
    M open = any;
    for (int row = 0; row < rows; ++row) {
        const V from = hn::Load(d, cover_from_ + row * pixels + first_col);
        const V to = hn::Load(d, cover_to_ + row * pixels + first_col);
        M some = hn::Le(from, to);
        M covered = hn::And(some, hn::And(hn::Gt(from, run_from), hn::Lt(to, run_to)));
        if (at_walls && !hn::AllFalse(d, some)) {
            const PixelBoxes<D> boxes(rays_, from_middle(run_->col + first_col),
                                      from_middle(run_->row + row), from, to);
            covered = hn::And(covered, boxes.inside());
            some = hn::AndNot(boxes.outside(), some);
        }
        const std::size_t pixel = first_pixel(row) + static_cast<std::size_t>(first_col);
        if (is_first) {
            nearest_.cover.mark_first(d, pixel, from, to, some, covered);
        } else if (!hn::AllFalse(d, some)) {
            nearest_.cover.mark(d, pixel, from, to, some, covered);
        }
        any = hn::Or(any, some);
        open = hn::Or(open, hn::AndNot(covered, some));
    }
    return {.any = !hn::AllFalse(d, any), .open = !hn::AllFalse(d, open)};
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::mark_cover() {
    const int cols = std::min(pixels, tile_.cols - run_->col);
    const int rows = std::min(pixels, tile_.rows - run_->row);
    const std::size_t pixel = first_pixel(0);
    const bool is_first = pixels == tile_block && !nearest_.cover.is_marked(pixel);
    Marked all;
    for (int col = 0; col < cols; col += lanes) {
        const Marked some = mark_columns(col, rows, is_first);
        all = {.any = all.any || some.any, .open = all.open || some.open};
    }
    if (all.any) nearest_.cover.mark_block(pixel, is_first && !all.open);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
