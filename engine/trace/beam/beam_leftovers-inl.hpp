// Leftovers: parts of rays on which there may be a root and whose cells are as small as they get.
// They are roots where f crosses 0, or cannot be decided. Included once for each instruction set,
// after Highway.

#if defined(ZEROSET_BEAM_LEFTOVERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_LEFTOVERS_INL
#undef ZEROSET_BEAM_LEFTOVERS_INL
#else
#define ZEROSET_BEAM_LEFTOVERS_INL
#endif

#include "engine/kernel/surface_facts.hpp"
#include "engine/trace/beam/beam_rays-inl.hpp"
#include "engine/trace/jumps.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real, class Cell>
void RayMarcher<Real, Cell>::look_around(Real finest) {
    if (leftovers_.empty()) return;
    ranges_.clear();
    const Margins margins = margins_around(finest);
    for (const LeftoverSegment<Real>& leftover : leftovers_)
        push_around(ranges_, leftover, margins);
    ranges_.evaluate(*leftovers_.front().segment.kernel);
    ranges_.evaluate_pieces(*leftovers_.front().segment.kernel);
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::push_around(RangeList<Real>& ranges,
                                         const LeftoverSegment<Real>& leftover,
                                         const Margins& margins) const {
    const auto from = static_cast<double>(leftover.from);
    const auto to = static_cast<double>(leftover.to);
    const auto push = [&](double s, double t) { ranges.push(leftover.segment.pixel, s, t); };
    for (std::size_t k = 0; k < margins.count; ++k) {
        const double margin = margins.sizes[k];
        push(from - margin, to + margin);
        push(from - margin, from - margin);
        push(to + margin, to + margin);
    }
}

template <class Real, class Cell>
bool RayMarcher<Real, Cell>::is_defined(const LeftoverSegment<Real>& what, Real finest) {
    if constexpr (std::is_same_v<Real, double>) {
        const auto& domain = surface_facts(frame_.kernel).domain;
        if (!domain) return false;
        const Margins margins = margins_around(finest);
        witness_ranges_.clear();
        push_around(witness_ranges_, what, margins);
        witness_ranges_.evaluate(domain);
        for (std::size_t k = 0; k < margins.count; ++k) {
            if (!witness_ranges_.continuous(3 * k)) return false;
        }
        return true;
    } else {
        return false;
    }
}

template <class Real, class Cell>
auto RayMarcher<Real, Cell>::witnessed(const LeftoverSegment<Real>& what, Real finest,
                                       bool continuous) -> std::optional<Crossing> {
    if constexpr (std::is_same_v<Real, double>) {
        const SurfaceFacts& f = surface_facts(frame_.kernel);
        if (!frame_.union_members.empty() || f.witnesses.empty()) return std::nullopt;
        if (!continuous && !f.defined_everywhere && !is_defined(what, finest)) return std::nullopt;
        for (const auto& witness : f.witnesses) {
            witness_ranges_.clear();
            push_around(witness_ranges_, what, margins_around(finest));
            witness_ranges_.evaluate(witness);
            if (auto found = crossing(witness_ranges_, 0, what, finest, false)) {
                found->trend = Trend::Unknown;
                return found;
            }
        }
    }
    return std::nullopt;
}

template <class Real, class Cell>
auto RayMarcher<Real, Cell>::crossing(const RangeList<Real>& ranges, std::size_t first,
                                      const LeftoverSegment<Real>& what, Real finest,
                                      bool continuous) const -> std::optional<Crossing> {
    const DepthRange clip = rays_.depths(rays_.u(what.segment.pixel % tile_size),
                                         rays_.v(what.segment.pixel / tile_size), 0.0, 0.0);
    const Margins margins = margins_around(finest);
    int before = 0;
    int behind = 0;
    for (std::size_t k = 0; k < margins.count; ++k) {
        const std::size_t box = first + 3 * k;
        const double from = static_cast<double>(what.from) - margins.sizes[k];
        const double to = static_cast<double>(what.to) + margins.sizes[k];
        if (from < clip.enter_hi || to > clip.exit_lo) break;
        if (ranges.vanishes(box + 1) || ranges.vanishes(box + 2))
            return Crossing{Trend::Unknown, to - from};
        if (!ranges.continuous(box) && !(k == 0 && continuous)) continue;
        // A sign holds for all of the bracket before, or behind, which has no root.
        if (before == 0) before = ranges.sign(box + 1);
        if (behind == 0) behind = ranges.sign(box + 2);
        if (before * behind < 0)
            return Crossing{before > 0 ? Trend::Falling : Trend::Rising, to - from};
    }
    return std::nullopt;
}

template <class Real, class Cell>
std::optional<Trend> RayMarcher<Real, Cell>::jump(const RangeList<Real>& ranges,
                                                  std::size_t first) const {
    if (!frame_.scene.jumps || ranges.continuous(first)) return std::nullopt;
    // Boxes before the bracket, each followed by the one behind it.
    const std::array boxes{first + 1, first + 4, first + 7};
    for (std::size_t k = 0; k + 1 < boxes.size(); ++k) {
        const int before = ranges.sign(boxes[k]);
        if (before * ranges.sign(boxes[k] + 1) >= 0) continue;
        // Towards a pole f grows: half as far from it, it is twice as large.
        constexpr Real much = static_cast<Real>(1.2);
        for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
            const Real near = ranges.least_size(boxes[k] + side);
            if (!(near <= much * ranges.least_size(boxes[k + 1] + side))) return std::nullopt;
        }
        return before > 0 ? Trend::Falling : Trend::Rising;
    }
    return std::nullopt;
}

template <class Real, class Cell>
bool RayMarcher<Real, Cell>::closes(const RangeList<Real>& ranges, std::size_t first,
                                    Real finest) const {
    const std::size_t count = margins_around(finest).count;
    bool any = false;
    for (std::size_t k = 0; k + 1 < count; ++k) {
        const std::size_t near = first + 3 * k;
        const std::size_t far = near + 3;
        if (ranges.sign(far + 1) * ranges.sign(far + 2) >= 0) continue;
        const auto falls = [&](std::size_t side) {
            return falls_to_zero(ranges.least_size(near + side), ranges.least_size(far + side));
        };
        if (!falls(1) || !falls(2)) return false;
        any = true;
    }
    return any;
}

template <class Real, class Cell>
template <class Undecided>
std::optional<RaySegment<Real>> RayMarcher<Real, Cell>::decide(std::size_t leftover,
                                                               const MarchSettings<Real>& settings,
                                                               Undecided undecided) {
    const LeftoverSegment<Real>& what = leftovers_[leftover];
    const std::size_t box = 3 * margins_around(settings.finest).count * leftover;
    RaySegment<Real> segment = what.segment;
    bool goes_on = true;
    if (!ranges_.excludes_zero(box)) {
        const bool continuous = what.continuous || ranges_.continuous(box);
        std::optional<Crossing> found;
        if (settings.certifies) {
            found = crossing(ranges_, box, what, settings.finest, what.continuous);
            if (!found) found = witnessed(what, settings.finest, continuous);
        }
        if (found) {
            const auto from = static_cast<double>(what.from);
            const auto to = static_cast<double>(what.to);
            // Four of the cells that are asked for, as certified_width promises.
            const bool narrow = found->width <= 4 * static_cast<double>(settings.asked);
            if (!narrow) counters_.coarse_width = std::max(counters_.coarse_width, found->width);
            nearest_.add_pending(segment.pixel, 0.5 * from + 0.5 * to,
                                 narrow ? Certificate::Certified : Certificate::Coarse,
                                 found->trend);
            return std::nullopt;
        }
        const auto jumps = settings.certifies ? jump(ranges_, box) : std::nullopt;
        if (jumps) {
            const double middle =
                0.5 * static_cast<double>(what.from) + 0.5 * static_cast<double>(what.to);
            nearest_.add_pending(segment.pixel, middle, Certificate::Jump, *jumps);
            return std::nullopt;
        }
        // At a hole, where f is not defined, there is no root.
        const bool is_drawn = continuous || (closes(ranges_, box, settings.finest) &&
                                             (surface_facts(frame_.kernel).defined_everywhere ||
                                              is_defined(what, settings.finest)));
        goes_on =
            undecided(segment.part(what.from, what.to, what.to - what.from), segment.to, is_drawn);
    }
    if (!goes_on || !go_behind(segment)) return std::nullopt;
    return segment;
}

template <class Real, class Cell>
template <class Undecided>
void RayMarcher<Real, Cell>::settle(std::span<const Doubt> doubts,
                                    const MarchSettings<Real>& settings, Undecided undecided) {
    for (std::size_t first = 0, end = 0; first < doubts.size(); first = end) {
        leftovers_.clear();
        for (; end < doubts.size() && doubts[end].kernel == doubts[first].kernel; ++end) {
            const Doubt& doubt = doubts[end];
            const auto from = static_cast<Real>(doubt.from);
            const auto to = static_cast<Real>(doubt.to);
            const RaySegment<Real> segment{.pixel = doubt.pixel,
                                           .inside = false,
                                           .from = from,
                                           .to = to,
                                           .step = to - from,
                                           .kernel = doubt.kernel};
            leftovers_.push_back({.segment = segment, .from = from, .to = to, .continuous = true});
        }
        if (frame_.stopped()) {
            for (const LeftoverSegment<Real>& leftover : leftovers_)
                undecided(leftover.segment, leftover.segment.to, false);
            continue;
        }
        look_around(settings.finest);
        for (std::size_t i = 0; i < leftovers_.size(); ++i)
            decide(i, settings, undecided);
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
