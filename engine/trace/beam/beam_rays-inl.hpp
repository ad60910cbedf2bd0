// Rays on their own, where no tile of pixels is small enough: segments of rays are cells without
// width. Those of which forms say little: beam_cuts-inl.hpp; what is left in the end:
// beam_rests-inl.hpp.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_RAYS_INL
#undef ZEROSET_BEAM_RAYS_INL
#else
#define ZEROSET_BEAM_RAYS_INL
#endif

#include "engine/trace/beam/beam_roots-inl.hpp"
#include "engine/trace/beam/beam_segments-inl.hpp"

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
    RayMarcher(const TraceFrame& frame, const BeamView& view, MarchMemory<Real>& memory,
               Found<Cell>& found, RootFinder<Cell>& roots, Counters& counters)
        : frame_(frame),
          view_(view),
          found_(found),
          roots_(roots),
          counters_(counters),
          ranges_(frame, view, memory.ranges, counters),
          witness_ranges_(frame, view, memory.witness_ranges, counters),
          segments_(memory.segments),
          next_(memory.next),
          rests_(memory.rests),
          asked_(memory.asked),
          memory_(memory),
          places_(memory.cells.places),
          forms_(memory.cells.forms),
          verdicts_(memory.cells.verdicts) {}

    void push(const Segment<Real>& segment) { segments_.push_back(segment); }

    /// Works off what has been pushed. `undecided(segment, continuous)` takes those segments that
    /// may still hold a root, and whether f is continuous there; it returns whether the ray goes on
    /// behind.
    template <class Undecided>
    void march(const MarchSettings<Real>& settings, Undecided undecided);
    /// Decides about roots that may be there by the signs of f around them.
    template <class Undecided>
    void settle(std::span<const Doubt> doubts, const MarchSettings<Real>& settings,
                Undecided undecided);

private:
    static constexpr std::size_t capacity = MarchMemory<Real>::capacity;
    /// How far around what is not cut any further signs are looked for: where the finest segments
    /// are near what numbers tell apart, farther than those, too, and where jumps are told from
    /// poles.
    struct Margins {
        std::array<double, 3> sizes;
        std::size_t count;
    };
    [[nodiscard]] Margins margins_around(Real finest) const {
        const auto width = static_cast<double>(finest);
        const double far = std::max(16 * view_.depth_error(), frame_.scene.jumps ? 4 * width : 0.0);
        return {{0.0, width, far}, far > width ? 3U : 2U};
    }
    /// Newton's method wants slopes that differ by no more than this factor.
    static constexpr Real most_bend = 16;

    /// How many segments from this one on have its kernel, at most those of a batch.
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
    void place(std::span<const Segment<Real>> segments, Real margin);
    void evaluate_forms(const Kernel& kernel, const FrustumOf<Real>& frustum, std::size_t count);
    /// What the forms say of segments.
    static void judge(SegmentCells<Real>& cells, std::size_t count, Real finest) {
        for (std::size_t i = 0; i < count; i += hn::Lanes(LanesOf<Real>()))
            judge_vector(cells, i, finest);
    }
    static void judge_vector(SegmentCells<Real>& cells, std::size_t i, Real finest);
    /// Finds the segments that are to be cut where a switch may change.
    void find_cuts(std::size_t count, Real margin);
    /// The parts of a segment before, at and behind where a switch may change.
    void cut(const Segment<Real>& segment, std::size_t i);
    /// Segments in which switches are open, by what each piece of f leaves.
    void narrow_by_pieces(const Kernel& kernel, const FrustumOf<Real>& frustum, std::size_t count,
                          Real finest);
    /// Rejects by the natural interval extension: of those that forms say little of.
    void ask_ranges(std::span<const Segment<Real>> segments);
    /// Goes on with a vector's segments, from the first on, after their cells were evaluated.
    void advance(std::span<const Segment<Real>> segments, std::size_t first, Real finest);
    /// Where cell i of a segment is not decided; false if it is not cut any further.
    bool narrow(Segment<Real>& segment, std::size_t i, Real finest);
    /// Where f is 0 from one depth to the other: the first point of that surely inside the clip
    /// region, if there is one.
    bool take_first(const Segment<Real>& segment, Real from, Real to);
    /// Evaluates f around what was not cut any further: boxes_a_rest boxes for each.
    void look_around(Real finest);
    struct Crossing {
        Trend trend;
        double width;  ///< of the bracket
    };
    /// Where f surely is 0 at one of its ends, or has opposite signs around it and is continuous
    /// between.
    [[nodiscard]] std::optional<Crossing> crossing(const RangeList<Real>& ranges, std::size_t first,
                                                   const Rest<Real>& what, Real finest,
                                                   bool continuous) const;
    /// How f goes where it changes its sign in a jump.
    [[nodiscard]] std::optional<Trend> jump(const RangeList<Real>& ranges, std::size_t first) const;
    /// Whether f surely is defined around it.
    bool is_defined(const Rest<Real>& what, Real finest);
    /// Where a function crosses 0 whose zeros are zeros of f.
    std::optional<Crossing> witnessed(const Rest<Real>& what, Real finest, bool continuous);
    void push_around(RangeList<Real>& ranges, const Rest<Real>& rest, const Margins& margins) const;
    /// The rest's segment where the ray goes on behind.
    template <class Undecided>
    std::optional<Segment<Real>> decide(std::size_t rest, const MarchSettings<Real>& settings,
                                        Undecided undecided);
    static bool go_behind(Segment<Real>& segment) {
        segment.from = segment.end();
        segment.step += segment.step;
        return segment.from < segment.to;
    }
    void solve(const Segment<Real>& segment, std::size_t i);

    const TraceFrame& frame_;
    const BeamView& view_;
    Found<Cell>& found_;
    RootFinder<Cell>& roots_;
    Counters& counters_;
    RangeList<Real> ranges_, witness_ranges_;
    std::vector<Segment<Real>>& segments_;
    std::vector<Segment<Real>>& next_;
    std::vector<Rest<Real>>& rests_;
    std::vector<std::size_t>& asked_;
    MarchMemory<Real>& memory_;
    CellPlaces<Real>& places_;
    Forms<Real>& forms_;
    Verdicts<Real>& verdicts_;
    bool spare_ = false;                 ///< whether twice the segments at work take no longer
    std::array<Real, tile_size> u_, v_;  ///< of the tile's columns and rows
};

template <class Real, class Cell>
void RayMarcher<Real, Cell>::place(std::span<const Segment<Real>> segments, Real margin) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Segment<Real>& segment = segments[i];
        const Real end = segment.end();
        const Real middle = Real{0.5} * segment.from + Real{0.5} * end;
        places_.u[i] = u_[segment.pixel % tile_size];
        places_.v[i] = v_[segment.pixel / tile_size];
        places_.s[i] = middle;
        places_.s_radius[i] = std::max(end - middle, middle - segment.from) + margin;
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
void RayMarcher<Real, Cell>::judge_vector(SegmentCells<Real>& cells, std::size_t i, Real finest) {
    const Forms<Real>& forms = cells.forms;
    Verdicts<Real>& verdicts = cells.verdicts;
    constexpr LanesOf<Real> d;
    constexpr auto three_fifths = static_cast<Real>(0.6);
    const hn::RebindToUnsigned<decltype(d)> du;
    const auto load = [&](const std::vector<Real>& column) {
        return hn::LoadU(d, column.data() + i);
    };
    const auto mask = [&](const std::vector<ContinuityMask<Real>>& masks) {
        return hn::MaskFromVec(hn::BitCast(d, hn::LoadU(du, masks.data() + i)));
    };
    const auto zero = hn::Zero(d);
    const auto c = load(forms.c);
    const auto k = load(forms.k[2]);
    const auto e = load(forms.e);
    const auto s = load(cells.places.s);
    const auto reach = load(cells.places.s_radius);
    const auto begin = load(verdicts.begin);
    const auto end = load(verdicts.end);
    // Where the linear part, widened by its error and the roundings here, may vanish.
    const auto sloped = hn::Gt(hn::Abs(k), zero);
    const auto inverse = hn::IfThenElseZero(sloped, hn::Div(reach, k));
    const auto middle = hn::NegMulAdd(c, inverse, s);
    const auto size = hn::Add(hn::Add(hn::Abs(s), hn::Abs(middle)), reach);
    const auto radius = hn::MulAdd(size, hn::Set(d, 8 * std::numeric_limits<Real>::epsilon()),
                                   hn::Mul(e, hn::Abs(inverse)));
    const auto lo = hn::Sub(middle, radius);
    const auto hi = hn::Add(middle, radius);
    const auto bounded = hn::And(sloped, hn::Le(lo, hi));  // false where NaN
    const auto from = hn::IfThenElse(bounded, hn::Max(begin, lo), begin);
    const auto to = hn::IfThenElse(bounded, hn::Min(end, hi), end);
    const auto far = hn::Gt(hn::Abs(c), hn::Add(hn::Abs(k), e));
    const auto rejected = hn::Or(hn::Or(far, mask(forms.nowhere)), hn::Gt(from, to));
    const auto continuous = mask(forms.continuous);
    const auto known = hn::Le(e, hn::Set(d, std::numeric_limits<Real>::max()));
    // The derivative's least and greatest size, if it keeps its sign.
    const auto rising = hn::Neg(load(forms.slope_neg_lo));
    const auto falling = hn::Neg(load(forms.slope_hi));
    const auto least = hn::Max(rising, falling);
    const auto most = hn::Neg(hn::Min(rising, falling));
    const auto straight =
        hn::And(hn::Gt(least, zero), hn::Le(most, hn::Mul(least, hn::Set(d, most_bend))));
    const auto length = hn::Sub(end, begin);
    const auto short_already = hn::Le(length, hn::Set(d, finest));
    hn::StoreU(from, d, verdicts.from.data() + i);
    hn::StoreU(to, d, verdicts.to.data() + i);
    hn::StoreU(hn::Min(hn::Max(middle, from), to), d, verdicts.guess.data() + i);
    const auto flat = hn::Eq(hn::Add(hn::Abs(c), hn::Abs(k)), zero);
    const auto finished = hn::And(rejected, hn::Ge(end, load(verdicts.last)));
    verdicts.bits[i / hn::Lanes(d)] = {
        bits_of(d, rejected),
        bits_of(d, finished),
        bits_of(d, hn::Or(flat, hn::Or(hn::Not(hn::And(continuous, known)), short_already))),
        bits_of(d, hn::And(continuous, straight)),
        bits_of(d, hn::And(bounded, hn::And(hn::Gt(lo, begin), hn::Lt(hi, end)))),
        bits_of(d, hn::Lt(hn::Sub(to, from), hn::Mul(length, hn::Set(d, three_fifths)))),
        0,
        0};
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::solve(const Segment<Real>& segment, std::size_t i) {
    const double s = static_cast<double>(places_.s[i]);
    const double reach = static_cast<double>(places_.s_radius[i]);
    roots_.push({.pixel = segment.pixel,
                 .inside = segment.inside,
                 .from = static_cast<double>(verdicts_.from[i]),
                 .to = static_cast<double>(verdicts_.to[i]),
                 .lo = s - reach,
                 .hi = s + reach,
                 .guess = static_cast<double>(verdicts_.guess[i]),
                 .slope_lo = -static_cast<double>(forms_.slope_neg_lo[i]),
                 .slope_hi = static_cast<double>(forms_.slope_hi[i]),
                 .r = static_cast<double>(forms_.r[i]),
                 .kernel = segment.kernel,
                 .kinked = segment.kernel->branches && forms_.branches_of(i).may_hold_kink(),
                 .again = false});
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::advance(std::span<const Segment<Real>> segments, std::size_t first,
                                     Real finest) {
    const std::size_t lanes = hn::Lanes(LanesOf<Real>());
    const auto& bits = verdicts_.bits[first / lanes];
    const LaneBits there = (LaneBits{1} << std::min(segments.size() - first, lanes)) - 1;
    const auto for_each = [&](LaneBits which, auto&& go_on) {
        for (; which != 0; which &= which - 1) {
            const std::size_t i = first + static_cast<std::size_t>(std::countr_zero(which));
            Segment<Real> segment = segments[i];
            if (segment.from > static_cast<Real>(found_.depth[segment.pixel])) continue;
            if (go_on(segment, i)) next_.push_back(segment);
        }
    };
    const LaneBits open = there & ~bits.rejected;
    for_each(there & bits.rejected & ~bits.finished,
             [](Segment<Real>& segment, std::size_t) { return go_behind(segment); });
    for_each(open & bits.monotone, [&](Segment<Real>& segment, std::size_t i) {
        solve(segment, i);
        return !(verdicts_.bit(&Verdicts<Real>::Bits::certain, i) && segment.inside) &&
               go_behind(segment);
    });
    for_each(open & ~bits.monotone,
             [&](Segment<Real>& segment, std::size_t i) { return narrow(segment, i, finest); });
}

template <class Real, class Cell>
bool RayMarcher<Real, Cell>::narrow(Segment<Real>& segment, std::size_t i, Real finest) {
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
        rests_.push_back({segment, from, to, forms_.continuous[i] != 0});
        return false;
    }
    if (spare_ && !verdicts_.bit(&Verdicts<Real>::Bits::contracts, i)) {
        // Both halves at once.
        const Real middle = from + Real{0.5} * width;
        next_.push_back(
            {segment.pixel, segment.inside, from, middle, middle - from, segment.kernel});
        next_.push_back(
            {segment.pixel, segment.inside, middle, segment.to, to - middle, segment.kernel});
        return false;
    }
    segment.from = from;
    // Whether it contracts is hard to predict.
    constexpr Real parts[] = {Real{0.5}, Real{1}};
    segment.step = width * parts[verdicts_.bit(&Verdicts<Real>::Bits::contracts, i) ? 1 : 0];
    return true;
}

template <class Real, class Cell>
bool RayMarcher<Real, Cell>::take_first(const Segment<Real>& segment, Real from, Real to) {
    auto first = static_cast<double>(from);
    auto last = static_cast<double>(to);
    if (!segment.inside) {
        const DepthRange clip = view_.depths(view_.u(segment.pixel % tile_size),
                                             view_.v(segment.pixel / tile_size), 0.0, 0.0);
        first = std::max(first, clip.enter_hi);
        last = std::min(last, clip.exit_lo);
    }
    if (!(first <= last)) return false;
    found_.add_pending(segment.pixel, first, Certificate::Certified, Trend::Unknown);
    return true;
}

template <class Real, class Cell>
template <class Undecided>
void RayMarcher<Real, Cell>::leave(std::size_t first, Undecided undecided) {
    for (const Segment<Real>& segment : std::span(segments_).subspan(first))
        undecided(segment, false);
    for (const Segment<Real>& segment : next_)
        undecided(segment, false);
    segments_.clear();
    roots_.solve();
}

template <class Real, class Cell>
template <class Undecided>
void RayMarcher<Real, Cell>::march(const MarchSettings<Real>& settings, Undecided undecided) {
    if (segments_.empty()) return;
    for (int i = 0; i < tile_size; ++i) {
        u_[static_cast<std::size_t>(i)] = static_cast<Real>(view_.u(i));
        v_[static_cast<std::size_t>(i)] = static_cast<Real>(view_.v(i));
    }
    const FrustumOf<Real> frustum = view_.frustum<Real>(1);
    const std::size_t lanes = hn::Lanes(LanesOf<Real>());
    while (!segments_.empty()) {
        next_.clear();
        for (std::size_t first = 0, count = 0; first < segments_.size(); first += count) {
            if (frame_.stopped()) return leave(first, undecided);
            count = same_kernel(first);
            const auto segments = std::span(segments_).subspan(first, count);
            place(segments, settings.margin);
            evaluate_forms(*segments.front().kernel, frustum, count);
            judge(memory_.cells, count, settings.finest);
            const Kernel& kernel = *segments.front().kernel;
            if (kernel.switches > 0) {
                find_cuts(count, settings.margin);
                if (!frame_.scene.jumps) narrow_by_pieces(kernel, frustum, count, settings.finest);
            }
            ask_ranges(segments);
            rests_.clear();
            spare_ = 2 * count <= lanes;
            for (std::size_t i = 0; i < count; i += lanes)
                advance(segments, i, settings.finest);
            look_around(settings.finest);
            for (std::size_t rest = 0; rest < rests_.size(); ++rest) {
                const auto segment = decide(rest, settings, undecided);
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
