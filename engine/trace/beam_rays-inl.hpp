// Rays on their own, where no tile of pixels is small enough: segments of rays are cells without
// width.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_RAYS_INL
#undef ZEROSET_BEAM_RAYS_INL
#else
#define ZEROSET_BEAM_RAYS_INL
#endif

#include "engine/trace/beam_roots-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A part of a ray still to be searched, from the front.
template <class Real>
struct Segment {
    std::uint32_t pixel;
    bool inside;  ///< surely inside the clip box
    Real from, to;
    Real step;  ///< how far the next cell reaches
    const Kernel* kernel;
};

/// Marches along rays in cells that shrink where they cannot be decided and grow behind.
/// `Cell`: the type of the tile's cells.
template <class Real, class Cell>
class RayMarcher {
public:
    RayMarcher(const TraceFrame& frame, const BeamView& view, Found<Cell>& found,
               RootFinder<Cell>& roots, Counters& counters)
        : frame_(frame), view_(view), found_(found), roots_(roots), counters_(counters) {
        places_.resize(capacity);
        forms_.resize(capacity);
    }

    void push(const Segment<Real>& segment) { segments_.push_back(segment); }

    /// Works off what has been pushed, down to segments `finest` wide; cells are longer than their
    /// part of the ray by `margin` at both ends. `undecided(segment, continuous)` takes those
    /// segments that may still hold a root, and whether f is continuous there; it returns whether
    /// the ray goes on behind.
    template <class Undecided>
    void march(Real finest, Real margin, double s_most, Undecided undecided);

private:
    static constexpr std::size_t capacity = 256;

    /// How many segments from this one on have its kernel, at most those of a batch.
    [[nodiscard]] std::size_t same_kernel(std::size_t first) const {
        const std::size_t most = std::min(capacity, segments_.size() - first);
        std::size_t count = 1;
        while (count < most && segments_[first + count].kernel == segments_[first].kernel)
            ++count;
        return count;
    }
    void place(std::span<const Segment<Real>> segments, Real margin);
    /// Goes on with one segment after its cell i was evaluated; false when it is finished.
    template <class Undecided>
    bool advance(Segment<Real>& segment, std::size_t i, Real finest, Undecided undecided);
    /// Whether the natural interval extension excludes roots in the cells of the segments, if any
    /// of these is as narrow as `finest`: it is sharper beside poles and jumps.
    void exclude_by_range(std::span<const Segment<Real>> segments, Real finest);

    const TraceFrame& frame_;
    const BeamView& view_;
    Found<Cell>& found_;
    RootFinder<Cell>& roots_;
    Counters& counters_;
    std::vector<Segment<Real>> segments_;
    CellPlaces<Real> places_;
    Forms<Real> forms_;
    std::vector<bool> excluded_ = std::vector<bool>(capacity);
};

template <class Real, class Cell>
void RayMarcher<Real, Cell>::exclude_by_range(std::span<const Segment<Real>> segments,
                                              Real finest) {
    std::fill(excluded_.begin(), excluded_.end(), false);
    const bool any = std::ranges::any_of(segments, [&](const Segment<Real>& segment) {
        return std::min(segment.step, segment.to - segment.from) <= finest;
    });
    if (!any) return;
    const std::size_t count = padded(segments.size());
    std::array<std::array<Real, capacity>, 6> ends;
    std::array<Real, capacity> f_neg_lo;
    std::array<Real, capacity> f_hi;
    std::array<ContinuityMask<Real>, capacity> continuous;
    for (std::size_t i = 0; i < count; ++i) {
        const Segment<Real>& segment = segments[std::min(i, segments.size() - 1)];
        const auto near = static_cast<double>(segment.from);
        const auto far = static_cast<double>(std::min(segment.to, segment.from + segment.step));
        const double col = segment.pixel % tile_size;
        const double row = segment.pixel / tile_size;
        const glm::dvec3 a = view_.point(col, row, near);
        const glm::dvec3 b = view_.point(col, row, far);
        for (int k = 0; k < 3; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            ends[axis][i] = upper_end(Real{}, view_.depth_error() - std::min(a[k], b[k]));
            ends[axis + 3][i] = upper_end(Real{}, view_.depth_error() + std::max(a[k], b[k]));
        }
    }
    counters_.range += segments.size();
    segments.front().kernel->range(
        RangeBatchOf<Real>{count,
                           {ends[0].data(), ends[1].data(), ends[2].data()},
                           {ends[3].data(), ends[4].data(), ends[5].data()},
                           frame_.scene.uniforms.template boxes<Real>(),
                           f_neg_lo.data(),
                           f_hi.data(),
                           continuous.data()});
    for (std::size_t i = 0; i < segments.size(); ++i)
        excluded_[i] = f_neg_lo[i] < 0 || f_hi[i] < 0;
}

template <class Real, class Cell>
void RayMarcher<Real, Cell>::place(std::span<const Segment<Real>> segments, Real margin) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Segment<Real>& segment = segments[i];
        const Real end = std::min(segment.to, segment.from + segment.step);
        const Real middle = Real{0.5} * segment.from + Real{0.5} * end;
        places_.u[i] = static_cast<Real>(view_.u(segment.pixel % tile_size));
        places_.v[i] = static_cast<Real>(view_.v(segment.pixel / tile_size));
        places_.s[i] = middle;
        places_.s_radius[i] = std::max(end - middle, middle - segment.from) + margin;
    }
}

template <class Real, class Cell>
template <class Undecided>
bool RayMarcher<Real, Cell>::advance(Segment<Real>& segment, std::size_t i, Real finest,
                                     Undecided undecided) {
    if (segment.from > static_cast<Real>(found_.depth[segment.pixel])) return false;
    const Real end = std::min(segment.to, segment.from + segment.step);
    const auto go_behind = [&] {
        segment.from = end;
        segment.step += segment.step;
        return segment.from < segment.to;
    };
    const Real c = forms_.c[i];
    const Real k = forms_.k[2][i];
    const Real e = forms_.e[i];
    if (excluded_[i] || forms_.nowhere[i] != 0 || std::abs(c) > std::abs(k) + e) {
        return go_behind();
    }
    const bool continuous = forms_.continuous[i] != 0;
    const bool sloped = forms_.slope_neg_lo[i] < 0 || forms_.slope_hi[i] < 0;
    // Where the linear part, widened by its error and the roundings here, may vanish.
    const Real inverse = std::abs(k) > 0 ? places_.s_radius[i] / k : Real{0};
    const Real middle = places_.s[i] - c * inverse;
    const Real radius = e * std::abs(inverse) +
                        8 * std::numeric_limits<Real>::epsilon() *
                            (std::abs(places_.s[i]) + std::abs(middle) + places_.s_radius[i]);
    const bool contracts = std::abs(k) > 0 && middle - radius <= middle + radius;
    const Real from = contracts ? std::max(segment.from, middle - radius) : segment.from;
    const Real to = contracts ? std::min(end, middle + radius) : end;
    if (from > to) return go_behind();
    if (continuous && sloped) {
        const double s = static_cast<double>(places_.s[i]);
        const double reach = static_cast<double>(places_.s_radius[i]);
        roots_.push(
            {segment.pixel, segment.inside, static_cast<double>(from), static_cast<double>(to),
             s - reach, s + reach, static_cast<double>(std::clamp(middle, from, to)),
             -static_cast<double>(forms_.slope_neg_lo[i]), static_cast<double>(forms_.slope_hi[i]),
             static_cast<double>(forms_.r[i]), segment.kernel});
        const bool certain = contracts && middle - radius > segment.from && middle + radius < end;
        return !(certain && segment.inside) && go_behind();
    }
    if (to - from <= finest || !(from < from + Real{0.5} * (to - from))) {
        return undecided(Segment<Real>{segment.pixel, segment.inside, from, to, to - from,
                                       segment.kernel},
                         continuous) &&
               go_behind();
    }
    const Real width = to - from;
    const bool contracted = width < static_cast<Real>(0.6) * (end - segment.from);
    segment.from = from;
    segment.step = contracted ? width : Real{0.5} * width;
    return true;
}

template <class Real, class Cell>
template <class Undecided>
void RayMarcher<Real, Cell>::march(Real finest, Real margin, double s_most, Undecided undecided) {
    const FrustumOf<Real> frustum = view_.frustum<Real>(1, s_most);
    while (!segments_.empty()) {
        std::size_t kept = 0;
        for (std::size_t first = 0, count = 0; first < segments_.size(); first += count) {
            count = same_kernel(first);
            place(std::span(segments_).subspan(first, count), margin);
            places_.pad(count);
            counters_.form += count;
            segments_[first].kernel->form(form_batch(frame_, frustum, 0, count, places_, forms_));
            exclude_by_range(std::span(segments_).subspan(first, count), finest);
            for (std::size_t i = 0; i < count; ++i) {
                Segment<Real> segment = segments_[first + i];
                if (advance(segment, i, finest, undecided)) segments_[kept++] = segment;
            }
        }
        segments_.resize(kept);
        roots_.solve();
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
