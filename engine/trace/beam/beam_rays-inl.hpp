// Rays on their own, where no tile of pixels is small enough: segments of rays are cells without
// width. Segments that forms say little of are treated in beam_cuts-inl.hpp, those that are left in
// the end in beam_leftovers-inl.hpp.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_RAYS_INL
#undef ZEROSET_BEAM_RAYS_INL
#else
#define ZEROSET_BEAM_RAYS_INL
#endif

#include "engine/trace/beam/beam_roots-inl.hpp"
#include "engine/trace/beam/beam_segments-inl.hpp"
#include "engine/trace/beam/beam_verdicts-inl.hpp"

#include <bit>
#include <optional>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Marches along rays in cells that shrink where they cannot be decided and grow behind.
/// `Cell`: the type of the tile's cells.
template <class Real, class Cell>
class RayMarcher {
public:
    RayMarcher(const TraceFrame& frame, const TileRays& rays, MarchMemory<Real>& memory,
               NearestRoots<Cell>& nearest, RootFinder<Cell>& roots, Counters& counters)
        : frame_(frame),
          rays_(rays),
          nearest_(nearest),
          roots_(roots),
          counters_(counters),
          ranges_(frame, rays, memory.ranges, counters),
          witness_ranges_(frame, rays, memory.witness_ranges, counters),
          segments_(memory.segments),
          next_(memory.next),
          leftovers_(memory.leftovers),
          asked_(memory.asked),
          memory_(memory),
          places_(memory.cells.places),
          forms_(memory.cells.forms),
          verdicts_(memory.cells.verdicts) {}

    void push(const RaySegment<Real>& segment) { segments_.push_back(segment); }

    /// Works off what has been pushed. `undecided(segment, end, continuous)` takes those segments
    /// that may still hold a root, where the longer one ends that they are the first parts of, and
    /// whether f is continuous there; it returns whether the ray goes on behind.
    template <class Undecided>
    void march(const MarchSettings<Real>& settings, Undecided undecided);
    /// Decides about roots that may be there by the signs of f around them.
    template <class Undecided>
    void settle(std::span<const Doubt> doubts, const MarchSettings<Real>& settings,
                Undecided undecided);

private:
    static constexpr std::size_t capacity = MarchMemory<Real>::capacity;
    /// Margins around a leftover within which signs are looked for: farther than the finest
    /// segments where those are near what numbers tell apart, and where jumps are told from poles.
    struct Margins {
        std::array<double, 3> sizes;
        std::size_t count;
    };
    [[nodiscard]] Margins margins_around(Real finest) const {
        const auto width = static_cast<double>(finest);
        const double far = std::max(16 * rays_.depth_error(), frame_.scene.jumps ? 4 * width : 0.0);
        return {{0.0, width, far}, far > width ? 3U : 2U};
    }

    /// The number of segments from this one on that have its kernel, at most those of a batch.
    [[nodiscard]] std::size_t same_kernel(std::size_t first) const {
        const std::size_t most = std::min(capacity, segments_.size() - first);
        std::size_t count = 1;
        while (count < most && segments_[first + count].kernel == segments_[first].kernel)
            ++count;
        return count;
    }
    /// Hands the segments from this one on over undecided, and those that go on.
    template <class Undecided>
    void leave(std::size_t first, Undecided undecided);
    void place(std::span<const RaySegment<Real>> segments, Real margin);
    void evaluate_forms(const Kernel& kernel, const FrustumOf<Real>& frustum, std::size_t count);
    /// Finds the segments that are to be cut where a switch may change.
    void find_cuts(std::size_t count, Real margin);
    /// The parts of a segment before, at and behind where a switch may change.
    void cut(const RaySegment<Real>& segment, std::size_t i);
    /// Narrows segments in which switches are open to what the pieces of f leave.
    void narrow_by_pieces(std::span<const RaySegment<Real>> segments,
                          const FrustumOf<Real>& frustum, Real finest);
    /// Rejects segments that forms say little of by the natural interval extension.
    void ask_ranges(std::span<const RaySegment<Real>> segments);
    /// Goes on with a vector's segments, from the first on, after their cells were evaluated.
    void advance(std::span<const RaySegment<Real>> segments, std::size_t first, Real finest);
    /// Shortens a segment whose cell i is not decided; false if that one is not cut any further.
    bool narrow(RaySegment<Real>& segment, std::size_t i, Real finest);
    /// Takes the first point surely inside the clip region, if there is one, of a part of a ray on
    /// which f is 0.
    bool take_first(const RaySegment<Real>& segment, Real from, Real to);
    /// Evaluates f around the leftovers: three boxes for each of the margins.
    void look_around(Real finest);
    struct Crossing {
        Trend trend;
        double width;  ///< of the bracket
    };
    /// The root of a leftover where f surely is 0 at one of its ends, or has opposite signs around
    /// it and is continuous between.
    [[nodiscard]] std::optional<Crossing> crossing(const RangeList<Real>& ranges, std::size_t first,
                                                   const LeftoverSegment<Real>& what, Real finest,
                                                   bool continuous) const;
    /// The trend of f where it changes its sign in a jump.
    [[nodiscard]] std::optional<Trend> jump(const RangeList<Real>& ranges, std::size_t first) const;
    /// Whether f changes its sign in a leftover and comes to 0 there from both sides, as far as f
    /// around it tells: a product of a sign and a root may be 0 where the sign jumps.
    [[nodiscard]] bool closes(const RangeList<Real>& ranges, std::size_t first, Real finest) const;
    /// Whether f surely is defined around a leftover.
    bool is_defined(const LeftoverSegment<Real>& what, Real finest);
    /// The root of a leftover where a function crosses 0 whose zeros are zeros of f.
    std::optional<Crossing> witnessed(const LeftoverSegment<Real>& what, Real finest,
                                      bool continuous);
    void push_around(RangeList<Real>& ranges, const LeftoverSegment<Real>& leftover,
                     const Margins& margins) const;
    /// The leftover's segment, where the ray goes on behind it.
    template <class Undecided>
    std::optional<RaySegment<Real>> decide(std::size_t leftover,
                                           const MarchSettings<Real>& settings,
                                           Undecided undecided);
    static bool go_behind(RaySegment<Real>& segment) {
        segment.from = segment.end();
        segment.step += segment.step;
        return segment.from < segment.to;
    }
    void solve(const RaySegment<Real>& segment, std::size_t i);

    const TraceFrame& frame_;
    const TileRays& rays_;
    NearestRoots<Cell>& nearest_;
    RootFinder<Cell>& roots_;
    Counters& counters_;
    RangeList<Real> ranges_, witness_ranges_;
    std::vector<RaySegment<Real>>& segments_;
    std::vector<RaySegment<Real>>& next_;
    std::vector<LeftoverSegment<Real>>& leftovers_;
    std::vector<std::size_t>& asked_;
    MarchMemory<Real>& memory_;
    CellPlaces<Real>& places_;
    Forms<Real>& forms_;
    Verdicts<Real>& verdicts_;
    bool spare_ = false;                 ///< whether twice the segments at work take no longer
    std::array<Real, tile_size> u_, v_;  ///< of the tile's columns and rows
};

template <class Real, class Cell>
void RayMarcher<Real, Cell>::place(std::span<const RaySegment<Real>> segments, Real margin) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const RaySegment<Real>& segment = segments[i];
        const Real end = segment.end();
        const Real middle = Real{0.5} * segment.from + Real{0.5} * end;
        places_.u[i] = u_[segment.pixel % tile_size];
        places_.v[i] = v_[segment.pixel / tile_size];
        places_.s[i] = middle;
        places_.s_radius[i] = std::max(end - middle, middle - segment.from) + margin;
        if (counters_.costs != nullptr) counters_.costs->add(segment.pixel);
        verdicts_.begin[i] = segment.from;
        verdicts_.end[i] = end;
        verdicts_.last[i] = segment.to;
    }
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::evaluate_forms(const Kernel& kernel, const FrustumOf<Real>& frustum,
                                            std::size_t count) {
    places_.pad(count);
    counters_.form += count;
    FormBatchOf<Real> batch = form_batch(frame_, kernel, frustum, 0, count, places_, forms_);
    if (kernel.switches > 0) {
        batch.cut_from = forms_.cut_from.data();
        batch.cut_to = forms_.cut_to.data();
    }
    kernel.ray_form(batch);
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::solve(const RaySegment<Real>& segment, std::size_t i) {
    const double s = static_cast<double>(places_.s[i]);
    const double s_radius = static_cast<double>(places_.s_radius[i]);
    roots_.push({.pixel = segment.pixel,
                 .inside = segment.inside,
                 .from = static_cast<double>(verdicts_.from[i]),
                 .to = static_cast<double>(verdicts_.to[i]),
                 .lo = s - s_radius,
                 .hi = s + s_radius,
                 .guess = static_cast<double>(verdicts_.guess[i]),
                 .slope_lo = -static_cast<double>(forms_.slope_neg_lo[i]),
                 .slope_hi = static_cast<double>(forms_.slope_hi[i]),
                 .r = static_cast<double>(forms_.r[i]),
                 .kernel = segment.kernel,
                 .kinked = segment.kernel->branches && forms_.branches_of(i).may_hold_kink(),
                 .again = false});
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::advance(std::span<const RaySegment<Real>> segments, std::size_t first,
                                     Real finest) {
    const auto& bits = verdicts_.bits[first / lanes<Real>];
    const LaneBits there = (LaneBits{1} << std::min(segments.size() - first, lanes<Real>)) - 1;
    const auto for_each = [&](LaneBits which, auto&& go_on) {
        for (; which != 0; which &= which - 1) {
            const std::size_t i = first + static_cast<std::size_t>(std::countr_zero(which));
            RaySegment<Real> segment = segments[i];
            if (segment.from > static_cast<Real>(nearest_.s[segment.pixel])) continue;
            if (go_on(segment, i)) next_.push_back(segment);
        }
    };
    // Go on behind rejected cells.
    const LaneBits open = there & ~bits.rejected;
    for_each(there & bits.rejected & ~bits.finished,
             [](RaySegment<Real>& segment, std::size_t) { return go_behind(segment); });
    // Solve monotone ones, and go on behind those that may have no root.
    for_each(open & bits.monotone, [&](RaySegment<Real>& segment, std::size_t i) {
        solve(segment, i);
        return !(verdicts_.bit(&Verdicts<Real>::Bits::certain, i) && segment.inside) &&
               go_behind(segment);
    });
    // Shorten the others.
    for_each(open & ~bits.monotone,
             [&](RaySegment<Real>& segment, std::size_t i) { return narrow(segment, i, finest); });
}

template <class Real, class Cell>
bool RayMarcher<Real, Cell>::narrow(RaySegment<Real>& segment, std::size_t i, Real finest) {
    const Real from = verdicts_.from[i];
    const Real to = verdicts_.to[i];
    const Real width = to - from;
    if (verdicts_.bit(&Verdicts<Real>::Bits::vanishes, i) && take_first(segment, from, to))
        return false;
    if (verdicts_.bit(&Verdicts<Real>::Bits::cut, i)) {
        cut(segment, i);
        return false;
    }
    if (width <= finest || !(from < from + Real{0.5} * width)) {
        leftovers_.push_back(
            {.segment = segment, .from = from, .to = to, .continuous = forms_.continuous[i] != 0});
        return false;
    }
    if (spare_ && !verdicts_.bit(&Verdicts<Real>::Bits::contracts, i)) {
        // Both halves at once.
        const Real middle = from + Real{0.5} * width;
        next_.push_back(segment.part(from, middle, middle - from));
        next_.push_back(segment.part(middle, segment.to, to - middle));
        return false;
    }
    segment.from = from;
    // Whether it contracts is hard to predict.
    constexpr Real parts[] = {Real{0.5}, Real{1}};
    segment.step = width * parts[verdicts_.bit(&Verdicts<Real>::Bits::contracts, i) ? 1 : 0];
    return true;
}

template <class Real, class Cell>
bool RayMarcher<Real, Cell>::take_first(const RaySegment<Real>& segment, Real from, Real to) {
    auto first = static_cast<double>(from);
    auto last = static_cast<double>(to);
    if (!segment.inside) {
        const DepthRange clip = rays_.depths(rays_.u(segment.pixel % tile_size),
                                             rays_.v(segment.pixel / tile_size), 0.0, 0.0);
        first = std::max(first, clip.enter_hi);
        last = std::min(last, clip.exit_lo);
    }
    if (!(first <= last)) return false;
    nearest_.add_pending(segment.pixel, first, Certificate::Certified, Trend::Unknown);
    return true;
}

template <class Real, class Cell>
template <class Undecided>
void RayMarcher<Real, Cell>::leave(std::size_t first, Undecided undecided) {
    for (const RaySegment<Real>& segment : std::span(segments_).subspan(first))
        undecided(segment, segment.to, false);
    for (const RaySegment<Real>& segment : next_)
        undecided(segment, segment.to, false);
    segments_.clear();
    roots_.solve();
}

template <class Real, class Cell>
template <class Undecided>
void RayMarcher<Real, Cell>::march(const MarchSettings<Real>& settings, Undecided undecided) {
    if (segments_.empty()) return;
    for (int i = 0; i < tile_size; ++i) {
        u_[static_cast<std::size_t>(i)] = static_cast<Real>(rays_.u(i));
        v_[static_cast<std::size_t>(i)] = static_cast<Real>(rays_.v(i));
    }
    const FrustumOf<Real> frustum = rays_.frustum<Real>(1);
    while (!segments_.empty()) {
        next_.clear();
        for (std::size_t first = 0, count = 0; first < segments_.size(); first += count) {
            if (frame_.stopped()) return leave(first, undecided);
            count = same_kernel(first);
            const auto segments = std::span(segments_).subspan(first, count);
            // Judge the next cells by their forms.
            place(segments, settings.margin);
            evaluate_forms(*segments.front().kernel, frustum, count);
            judge(memory_.cells, count, settings.finest);
            // Say more where forms say little.
            if (segments.front().kernel->switches > 0) {
                find_cuts(count, settings.margin);
                if (!frame_.scene.jumps) narrow_by_pieces(segments, frustum, settings.finest);
            }
            ask_ranges(segments);
            // Go on, and decide what is not cut any further.
            leftovers_.clear();
            spare_ = 2 * count <= lanes<Real>;
            for (std::size_t i = 0; i < count; i += lanes<Real>)
                advance(segments, i, settings.finest);
            look_around(settings.finest);
            for (std::size_t i = 0; i < leftovers_.size(); ++i) {
                const auto segment = decide(i, settings, undecided);
                if (segment) next_.push_back(*segment);
            }
        }
        segments_.swap(next_);
        roots_.solve();
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
