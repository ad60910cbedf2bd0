// Rays on their own, where no tile of pixels is small enough: segments of rays are cells without
// width.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_RAYS_INL
#undef ZEROSET_BEAM_RAYS_INL
#else
#define ZEROSET_BEAM_RAYS_INL
#endif

#include "engine/trace/beam_ranges-inl.hpp"
#include "engine/trace/beam_roots-inl.hpp"

#include <optional>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A part of a ray still to be searched, from the front.
template <class Real>
struct Segment {
    std::uint32_t pixel;
    bool inside;  ///< surely inside the clip box
    Real from, to;
    Real step;             ///< how far the next cell reaches
    const Kernel* kernel;  ///< of f on it

    [[nodiscard]] Real end() const { return std::min(to, from + step); }
};

/// How a march ends.
template <class Real>
struct MarchSettings {
    Real finest;     ///< segments are not made shorter
    Real margin;     ///< cells are longer than their part of the ray by this at both ends
    bool certifies;  ///< brackets of some `finest` are narrow enough to certify a root
};

/// What is left of a segment that is not cut any further.
template <class Real>
struct Rest {
    Segment<Real> segment;
    Real from, to;  ///< where the root may be
    bool continuous;
};

/// What a RayMarcher keeps; empty between marches but for the room.
template <class Real>
struct MarchMemory {
    static constexpr std::size_t capacity = 256;

    std::vector<Segment<Real>> segments;
    std::vector<Rest<Real>> rests;  ///< of the batch at work
    std::vector<std::size_t> asked;
    CellPlaces<Real> places;
    Forms<Real> forms;
    RangeMemory<Real> ranges;
    std::array<bool, capacity> excluded{};

    MarchMemory() {
        places.resize(capacity);
        forms.resize(capacity);
    }
};

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
          segments_(memory.segments),
          rests_(memory.rests),
          asked_(memory.asked),
          places_(memory.places),
          forms_(memory.forms),
          excluded_(memory.excluded) {}

    void push(const Segment<Real>& segment) { segments_.push_back(segment); }

    /// Works off what has been pushed. `undecided(segment, continuous)` takes those segments that
    /// may still hold a root, and whether f is continuous there; it returns whether the ray goes on
    /// behind.
    template <class Undecided>
    void march(const MarchSettings<Real>& settings, Undecided undecided);

private:
    static constexpr std::size_t capacity = MarchMemory<Real>::capacity;
    static constexpr std::size_t boxes_a_rest = 6;
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
    void place(std::span<const Segment<Real>> segments, Real margin);
    void evaluate_forms(const Kernel& kernel, const FrustumOf<Real>& frustum, std::size_t count);
    /// Finds those segments that the natural interval extension rejects: of those that forms say
    /// little of.
    void ask_ranges(std::span<const Segment<Real>> segments, Real finest);
    /// Goes on with one segment after its cell i was evaluated; false when it is finished.
    bool advance(Segment<Real>& segment, std::size_t i, Real finest);
    /// Evaluates f around what was not cut any further: boxes_a_rest boxes for each.
    void look_around(Real finest);
    /// Whether f surely has opposite signs around it, and is continuous between.
    [[nodiscard]] bool crosses(std::size_t rest, Real finest) const;
    /// The rest's segment where the ray goes on behind.
    template <class Undecided>
    std::optional<Segment<Real>> decide(std::size_t rest, const MarchSettings<Real>& settings,
                                        Undecided undecided);
    [[nodiscard]] bool rejected(std::size_t i) const {
        return forms_.nowhere[i] != 0 ||
               std::abs(forms_.c[i]) > std::abs(forms_.k[2][i]) + forms_.e[i];
    }
    static bool go_behind(Segment<Real>& segment) {
        segment.from = segment.end();
        segment.step += segment.step;
        return segment.from < segment.to;
    }
    void solve(const Segment<Real>& segment, std::size_t i, Real from, Real to, Real guess);

    const TraceFrame& frame_;
    const BeamView& view_;
    Found<Cell>& found_;
    RootFinder<Cell>& roots_;
    Counters& counters_;
    RangeList<Real> ranges_;
    std::vector<Segment<Real>>& segments_;
    std::vector<Rest<Real>>& rests_;
    std::vector<std::size_t>& asked_;
    CellPlaces<Real>& places_;
    Forms<Real>& forms_;
    std::array<bool, capacity>& excluded_;
};

template <class Real, class Cell>
void RayMarcher<Real, Cell>::place(std::span<const Segment<Real>> segments, Real margin) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Segment<Real>& segment = segments[i];
        const Real end = segment.end();
        const Real middle = Real{0.5} * segment.from + Real{0.5} * end;
        places_.u[i] = static_cast<Real>(view_.u(segment.pixel % tile_size));
        places_.v[i] = static_cast<Real>(view_.v(segment.pixel / tile_size));
        places_.s[i] = middle;
        places_.s_radius[i] = std::max(end - middle, middle - segment.from) + margin;
    }
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::evaluate_forms(const Kernel& kernel, const FrustumOf<Real>& frustum,
                                            std::size_t count) {
    places_.pad(count);
    counters_.form += count;
    kernel.ray_form(form_batch(frame_, frustum, 0, count, places_, forms_));
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::ask_ranges(std::span<const Segment<Real>> segments, Real finest) {
    ranges_.clear();
    asked_.clear();
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Segment<Real>& segment = segments[i];
        excluded_[i] = rejected(i);
        const bool weak = forms_.continuous[i] == 0 || segment.end() - segment.from <= finest;
        if (excluded_[i] || !weak) continue;
        asked_.push_back(i);
        ranges_.push(segment.pixel, static_cast<double>(segment.from),
                     static_cast<double>(segment.end()));
    }
    ranges_.evaluate(*segments.front().kernel);
    for (std::size_t k = 0; k < asked_.size(); ++k)
        excluded_[asked_[k]] = ranges_.excludes_zero(k);
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::solve(const Segment<Real>& segment, std::size_t i, Real from, Real to,
                                   Real guess) {
    const double s = static_cast<double>(places_.s[i]);
    const double reach = static_cast<double>(places_.s_radius[i]);
    roots_.push({segment.pixel, segment.inside, static_cast<double>(from), static_cast<double>(to),
                 s - reach, s + reach, static_cast<double>(guess),
                 -static_cast<double>(forms_.slope_neg_lo[i]),
                 static_cast<double>(forms_.slope_hi[i]), static_cast<double>(forms_.r[i]),
                 segment.kernel, false});
}

template <class Real, class Cell>
bool RayMarcher<Real, Cell>::advance(Segment<Real>& segment, std::size_t i, Real finest) {
    if (segment.from > static_cast<Real>(found_.depth[segment.pixel])) return false;
    if (excluded_[i]) return go_behind(segment);
    const Real end = segment.end();
    const Real c = forms_.c[i];
    const Real k = forms_.k[2][i];
    const Real e = forms_.e[i];
    const bool continuous = forms_.continuous[i] != 0;
    // Where the linear part, widened by its error and the roundings here, may vanish.
    const Real inverse = std::abs(k) > 0 ? places_.s_radius[i] / k : Real{0};
    const Real middle = places_.s[i] - c * inverse;
    const Real radius = e * std::abs(inverse) +
                        8 * std::numeric_limits<Real>::epsilon() *
                            (std::abs(places_.s[i]) + std::abs(middle) + places_.s_radius[i]);
    const bool contracts = std::abs(k) > 0 && middle - radius <= middle + radius;
    const Real from = contracts ? std::max(segment.from, middle - radius) : segment.from;
    const Real to = contracts ? std::min(end, middle + radius) : end;
    if (from > to) return go_behind(segment);
    const Real rising = -forms_.slope_neg_lo[i];
    const Real falling = -forms_.slope_hi[i];
    // The derivative's least and greatest size, if it keeps its sign.
    const Real least = std::max(rising, falling);
    const Real most = -std::min(rising, falling);
    if (continuous && least > 0 && most <= most_bend * least) {
        solve(segment, i, from, to, std::clamp(middle, from, to));
        const bool certain = contracts && middle - radius > segment.from && middle + radius < end;
        return !(certain && segment.inside) && go_behind(segment);
    }
    if (to - from <= finest || !(from < from + Real{0.5} * (to - from))) {
        rests_.push_back({segment, from, to, continuous});
        return false;
    }
    const Real width = to - from;
    const bool contracted = width < static_cast<Real>(0.6) * (end - segment.from);
    segment.from = from;
    segment.step = contracted ? width : Real{0.5} * width;
    return true;
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::look_around(Real finest) {
    if (rests_.empty()) return;
    ranges_.clear();
    const auto width = static_cast<double>(finest);
    for (const Rest<Real>& rest : rests_) {
        const auto from = static_cast<double>(rest.from);
        const auto to = static_cast<double>(rest.to);
        const auto push = [&](double s, double t) { ranges_.push(rest.segment.pixel, s, t); };
        push(from, to);
        push(from - width, to + width);
        for (const double s : {from, to, from - width, to + width})
            push(s, s);
    }
    ranges_.evaluate(*rests_.front().segment.kernel);
}

template <class Real, class Cell>
bool RayMarcher<Real, Cell>::crosses(std::size_t rest, Real finest) const {
    const auto sign = [&](std::size_t place) {
        return ranges_.sign(boxes_a_rest * rest + 2 + place);
    };
    const auto continuous = [&](std::size_t box) {
        return ranges_.continuous(boxes_a_rest * rest + box);
    };
    const Rest<Real>& what = rests_[rest];
    const DepthRange clip = view_.depths(view_.u(what.segment.pixel % tile_size),
                                         view_.v(what.segment.pixel / tile_size), 0.0, 0.0);
    const auto inside = [&](double margin) {
        return static_cast<double>(what.from) - margin >= clip.enter_hi &&
               static_cast<double>(what.to) + margin <= clip.exit_lo;
    };
    const int before = sign(0);
    const int behind = sign(1);
    const bool close = inside(0.0) && (what.continuous || continuous(0));
    if (close && before * behind < 0) return true;
    const bool around = inside(static_cast<double>(finest)) && continuous(1);
    return around && (before != 0 ? before : sign(2)) * (behind != 0 ? behind : sign(3)) < 0;
}

template <class Real, class Cell>
template <class Undecided>
std::optional<Segment<Real>> RayMarcher<Real, Cell>::decide(std::size_t rest,
                                                            const MarchSettings<Real>& settings,
                                                            Undecided undecided) {
    const Rest<Real>& what = rests_[rest];
    Segment<Real> segment = what.segment;
    bool goes_on = true;
    if (!ranges_.excludes_zero(boxes_a_rest * rest)) {
        if (settings.certifies && crosses(rest, settings.finest)) {
            const auto from = static_cast<double>(what.from);
            const auto to = static_cast<double>(what.to);
            found_.add_pending(segment.pixel, 0.5 * from + 0.5 * to, Certificate::Certified);
            return std::nullopt;
        }
        const bool continuous = what.continuous || ranges_.continuous(boxes_a_rest * rest);
        goes_on = undecided(Segment<Real>{segment.pixel, segment.inside, what.from, what.to,
                                          what.to - what.from, segment.kernel},
                            continuous);
    }
    if (!goes_on || !go_behind(segment)) return std::nullopt;
    return segment;
}

template <class Real, class Cell>
template <class Undecided>
void RayMarcher<Real, Cell>::march(const MarchSettings<Real>& settings, Undecided undecided) {
    if (segments_.empty()) return;
    const FrustumOf<Real> frustum = view_.frustum<Real>(1);
    while (!segments_.empty()) {
        std::size_t kept = 0;
        for (std::size_t first = 0, count = 0; first < segments_.size(); first += count) {
            count = same_kernel(first);
            const auto segments = std::span(segments_).subspan(first, count);
            place(segments, settings.margin);
            evaluate_forms(*segments.front().kernel, frustum, count);
            ask_ranges(segments, settings.finest);
            rests_.clear();
            for (std::size_t i = 0; i < count; ++i) {
                Segment<Real> segment = segments[i];
                if (advance(segment, i, settings.finest)) segments_[kept++] = segment;
            }
            look_around(settings.finest);
            for (std::size_t rest = 0; rest < rests_.size(); ++rest) {
                const auto segment = decide(rest, settings, undecided);
                if (segment) segments_[kept++] = *segment;
            }
        }
        segments_.resize(kept);
        roots_.solve();
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
