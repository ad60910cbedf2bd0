// Segments of rays of which their forms say little: cut where a switch may change, looked at piece
// by piece, or by natural interval extensions. Included once for each instruction set, after
// Highway.

#if defined(ZEROSET_BEAM_CUTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_CUTS_INL
#undef ZEROSET_BEAM_CUTS_INL
#else
#define ZEROSET_BEAM_CUTS_INL
#endif

#include "engine/trace/beam/beam_rays-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real, class Cell>
void RayMarcher<Real, Cell>::find_cuts(std::size_t count, Real margin) {
    constexpr auto little = static_cast<Real>(0.25);
    constexpr auto rounding = 4 * std::numeric_limits<Real>::epsilon();
    for (std::size_t i = 0; i < count; ++i) {
        if (forms_.continuous[i] != 0 || verdicts_.bit(&Verdicts<Real>::Bits::rejected, i)) {
            continue;
        }
        // Wide enough for the parts beside it to be free of the switch, with their margins.
        const Real around = static_cast<Real>(1.25) * margin + rounding * std::abs(places_.s[i]);
        const Real s_radius = places_.s_radius[i];
        const Real from =
            std::max(verdicts_.from[i], places_.s[i] + forms_.cut_from[i] * s_radius - around);
        const Real to =
            std::min(verdicts_.to[i], places_.s[i] + forms_.cut_to[i] * s_radius + around);
        // A switch at the very end of the segment has been cut off already.
        if (!(to - from >= little * around)) continue;
        if (!(to - from <= little * (verdicts_.to[i] - verdicts_.from[i]))) continue;
        verdicts_.cut_from[i] = from;
        verdicts_.cut_to[i] = to;
        verdicts_.set_bit(&Verdicts<Real>::Bits::cut, i);
    }
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::cut(const RaySegment<Real>& segment, std::size_t i) {
    const auto push = [&](Real from, Real to, Real end) {
        if (from < to) next_.push_back(segment.part(from, to, end - from));
    };
    const Real cut_from = verdicts_.cut_from[i];
    const Real cut_to = verdicts_.cut_to[i];
    push(verdicts_.from[i], cut_from, cut_from);
    push(cut_from, cut_to, cut_to);
    push(cut_to, segment.to, verdicts_.to[i] > cut_to ? verdicts_.to[i] : segment.to);
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::narrow_by_pieces(std::span<const RaySegment<Real>> segments,
                                              const FrustumOf<Real>& frustum, Real finest) {
    const Kernel& kernel = *segments.front().kernel;
    const std::size_t count = segments.size();
    const auto is_open = [&](std::size_t i) {
        return forms_.branches_of(i).outcomes() > 0 &&
               !verdicts_.bit(&Verdicts<Real>::Bits::rejected, i) &&
               !verdicts_.bit(&Verdicts<Real>::Bits::cut, i);
    };
    // Hold the first open switch of each cell at each of its outcomes.
    memory_.pieces.begin(kernel.switches);
    for (std::size_t i = 0; i < count; ++i) {
        if (is_open(i)) memory_.pieces.push(i, forms_.branches_of(i));
    }
    SegmentCells<Real>& of = memory_.cells_of_pieces();
    constexpr Real nothing = std::numeric_limits<Real>::infinity();
    memory_.left_from.assign(count, nothing);
    memory_.left_to.assign(count, -nothing);
    // Join what the pieces leave of each cell.
    const auto evaluate = [&](PieceList<Real>& list) {
        for (std::size_t k = 0; k < list.size(); ++k)
            of.copy_cell(memory_.cells, list.cell(k), k);
        of.places.pad(list.size());
        counters_.form += list.size();
        for (std::size_t k = 0; counters_.costs != nullptr && k < list.size(); ++k)
            counters_.costs->add(segments[list.cell(k)].pixel);
        kernel.ray_form(
            form_batch(frame_, kernel, frustum, 0, list.size(), of.places, of.forms, list.held()));
        judge(of, list.size(), finest);
    };
    const auto keep = [&](std::size_t cell, std::size_t k) {
        memory_.left_from[cell] = std::min(memory_.left_from[cell], of.verdicts.from[k]);
        memory_.left_to[cell] = std::max(memory_.left_to[cell], of.verdicts.to[k]);
    };
    memory_.pieces.visit(
        MarchMemory<Real>::most_switches, evaluate,
        [&](std::size_t k) { return of.verdicts.bit(&Verdicts<Real>::Bits::rejected, k); },
        [&](std::size_t k) { return of.forms.branches_of(k); }, keep);
    for (std::size_t i = 0; i < count; ++i) {
        if (is_open(i)) verdicts_.narrow(i, memory_.left_from[i], memory_.left_to[i]);
    }
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::ask_ranges(std::span<const RaySegment<Real>> segments) {
    ranges_.clear();
    asked_.clear();
    for (std::size_t first = 0; first < segments.size(); first += lanes<Real>) {
        const auto& bits = verdicts_.bits[first / lanes<Real>];
        for (LaneBits open = bits.weak & ~bits.rejected; open != 0; open &= open - 1) {
            const std::size_t i = first + static_cast<std::size_t>(std::countr_zero(open));
            if (i >= segments.size()) break;
            asked_.push_back(i);
            ranges_.push(segments[i].pixel, static_cast<double>(verdicts_.begin[i]),
                         static_cast<double>(verdicts_.end[i]));
        }
    }
    ranges_.evaluate(*segments.front().kernel);
    for (std::size_t k = 0; k < asked_.size(); ++k) {
        if (ranges_.excludes_zero(k)) verdicts_.reject(asked_[k]);
        if (ranges_.vanishes(k)) verdicts_.set_bit(&Verdicts<Real>::Bits::vanishes, asked_[k]);
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
