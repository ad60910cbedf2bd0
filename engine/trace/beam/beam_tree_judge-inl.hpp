// The cells of a tile judged by forms, pieces and natural interval extensions.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_TREE_JUDGE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_TREE_JUDGE_INL
#undef ZEROSET_BEAM_TREE_JUDGE_INL
#else
#define ZEROSET_BEAM_TREE_JUDGE_INL
#endif

#include "engine/trace/beam/beam_tree-inl.hpp"

#include <algorithm>
#include <limits>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real>
std::span<const CellRun> CellTree<Real>::judge(int pixels) {
    const FrustumOf<Real> frustum = rays_.frustum<Real>(pixels);
    cells_->runs.end(cells_->size);
    cells_->place(rays_, pixels, margin_of(pixels));
    for (CellRun& run : cells_->runs.all())
        evaluate(frame_, frustum, run, cells_->places, cells_->forms, counters_);
    tell_costs(std::span(cells_->tile).first(cells_->size), pixels);
    CellJudge<Real>(rays_, pixels).judge(*cells_);
    for (const CellRun& run : cells_->runs.all()) {
        if (run.kernel->switches > 0 && !frame_.scene.jumps) narrow_by_pieces(run, frustum, pixels);
        reject_by_ranges(run, pixels);
    }
    return cells_->runs.all();
}

template <class Real>
void CellTree<Real>::narrow_by_pieces(const CellRun& run, const FrustumOf<Real>& frustum,
                                      int pixels) {
    constexpr int most_switches = 1;
    // Hold the first open switch of each cell at each of its outcomes.
    Cells<Real>& of = pieces_.cells;
    pieces_.pieces.begin(run.kernel->switches);
    pieces_.left.assign(run.count, {});
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
        const BranchBits branches = cells_->forms.branches_of(i);
        if (branches.outcomes() == 0 || cells_->bit(&CellBits::rejected, i)) continue;
        pieces_.pieces.push(i, branches);
    }
    // Join what the pieces leave of each cell.
    const CellJudge<Real> judge(rays_, pixels);
    const auto evaluate = [&](PieceList<Real>& list) {
        of.clear();
        of.reserve(list.size());
        for (std::size_t k = 0; k < list.size(); ++k)
            of.push_copy(*cells_, list.cell(k));
        of.places.pad(of.size);
        counters_.form += of.size;
        tell_costs(std::span(of.tile).first(of.size), pixels);
        run.kernel->form(
            form_batch(frame_, *run.kernel, frustum, 0, of.size, of.places, of.forms, list.held()));
        judge.judge(of);
    };
    const auto keep = [&](std::size_t cell, std::size_t k) {
        auto& left = pieces_.left[cell - run.first];
        for (std::size_t q = 0; q < 4; ++q) {
            const Real from = of.child_from[q][k];
            const Real to = of.child_to[q][k];
            const bool empty = !(from <= to);
            left.from[q] = left.any ? std::min(left.from[q], from) : from;
            if (!left.any) left.to[q] = -std::numeric_limits<Real>::infinity();
            if (!empty) left.to[q] = std::max(left.to[q], to);
        }
        left.any = true;
    };
    pieces_.pieces.visit(
        most_switches, evaluate, [&](std::size_t k) { return of.bit(&CellBits::rejected, k); },
        [&](std::size_t k) { return of.forms.branches_of(k); }, keep);
    // Narrow the cells to it.
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
        if (cells_->forms.branches_of(i).outcomes() == 0 || cells_->bit(&CellBits::rejected, i))
            continue;
        const auto& left = pieces_.left[i - run.first];
        if (!left.any) {
            cells_->set_bit(&CellBits::rejected, i);
            continue;
        }
        for (std::size_t q = 0; q < 4; ++q) {
            cells_->child_from[q][i] = std::max(cells_->child_from[q][i], left.from[q]);
            cells_->child_to[q][i] = std::min(cells_->child_to[q][i], left.to[q]);
        }
    }
}

template <class Real>
void CellTree<Real>::reject_by_ranges(const CellRun& run, int pixels) {
    ranges_.clear();
    asked_.clear();
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
        const bool told = cells_->forms.continuous[i] != 0 && cells_->forms.known(i) &&
                          !cells_->bit(&CellBits::flat, i);
        if (told || cells_->bit(&CellBits::rejected, i)) continue;
        asked_.push_back(i);
        ranges_.push(cells_->tile[i], pixels, static_cast<double>(cells_->from[i]),
                     static_cast<double>(cells_->to[i]));
    }
    ranges_.evaluate(*run.kernel);
    for (std::size_t k = 0; k < asked_.size(); ++k) {
        if (ranges_.excludes_zero(k)) cells_->set_bit(&CellBits::rejected, asked_[k]);
        if (ranges_.vanishes(k) && cells_->tile[asked_[k]].inside != 0) cells_->finish(asked_[k]);
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
