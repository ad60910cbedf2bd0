// Lists of the rays that may meet a leaf, and of those that may meet pieces of it.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_PATCH_LISTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_PATCH_LISTS_INL
#undef ZEROSET_PATCH_LISTS_INL
#else
#define ZEROSET_PATCH_LISTS_INL
#endif

#include "engine/trace/patch/patch_outline.hpp"
#include "engine/trace/patch/patch_squares-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Some rays of the lists: from `first` on.
struct RaySpan {
    std::size_t first, count;
};

/// The rays of a leaf that may meet some part of it, one list behind the other.
class RayLists {
public:
    RayLists(const SightAxes& axes, const LeafRays& rays, LeafLists& lists)
        : axes_(axes), rays_(rays), lists_(lists) {}

    /// Puts the rays through an outline's pixels whose reach is not before `near` into the lists;
    /// returns how many.
    std::size_t gather(const LeafPixels& pixels, double near) {
        std::size_t count = 0;
        for (const TileRect& rect : pixels.rects)
            count = gather(*pixels.outline, rect, near, count);
        return count;
    }

    /// Lists the rays through some pixels that may meet a piece; where there is an outline, the
    /// first `gathered` rays of the lists take the place of the rectangles.
    RaySpan list(const Piece& piece, const LeafPixels& pixels, std::size_t gathered) {
        const QuadraticForm form(piece, axes_);
        const double near = piece.sight.depths().near;
        std::size_t count = keep_met(form, gathered);
        if (pixels.outline == nullptr) {
            for (const TileRect& rect : pixels.rects)
                count = list(form, rect, near, count);
        }
        count = list(form, pixels.others, near, count);
        repeat_last(0, count);
        return {.first = 0, .count = count};
    }

    /// Lists those rays again, behind them, that the piece's linear form does not reject, with
    /// where it has their zeros.
    RaySpan list(const Piece& piece, const RaySpan& rays) {
        const QuadraticForm form(piece, axes_);
        const double near = piece.sight.depths().near;
        const std::size_t first = rays.first + rays.count;
        lists_.reserve(first, rays.count);
        std::size_t count = 0;
        for (std::size_t i = 0; i < rays.count; i += lanes<float>) {
            const std::size_t at = rays.first + i;
            const auto pixels = hn::LoadU(di, pixels_at(at));
            const LaneBits wanted = first_bits(rays.count - i) & nearer(near, pixels);
            if (wanted == 0) continue;
            count += put(form, lists(), pair(u(at)), pair(v(at)), pixels, wanted, first + count);
        }
        repeat_last(first, count);
        return {.first = first, .count = count};
    }

    /// Rays that surround those of the list.
    SightRays bounds_of(const RaySpan& rays) {
        V<double> u_lo = hn::LoadU(d<double>, u(rays.first));
        V<double> v_lo = hn::LoadU(d<double>, v(rays.first));
        V<double> u_hi = u_lo;
        V<double> v_hi = v_lo;
        for (std::size_t i = lanes<double>; i < rays.count; i += lanes<double>) {
            const V<double> us = hn::LoadU(d<double>, u(rays.first + i));
            const V<double> vs = hn::LoadU(d<double>, v(rays.first + i));
            u_lo = hn::Min(u_lo, us);
            u_hi = hn::Max(u_hi, us);
            v_lo = hn::Min(v_lo, vs);
            v_hi = hn::Max(v_hi, vs);
        }
        const auto range = [&](V<double> lo, V<double> hi) HWY_ATTR {
            const double least = hn::GetLane(hn::MinOfLanes(d<double>, lo));
            const double most = hn::GetLane(hn::MaxOfLanes(d<double>, hi));
            const double middle = 0.5 * least + 0.5 * most;
            return std::array{middle, std::max(most - middle, middle - least)};
        };
        const auto [u_middle, u_radius] = range(u_lo, u_hi);
        const auto [v_middle, v_radius] = range(v_lo, v_hi);
        return {
            .middle = {.u = u_middle, .v = v_middle}, .u_radius = u_radius, .v_radius = v_radius};
    }

    double* u(std::size_t i) { return lists_.u.data() + i; }
    double* v(std::size_t i) { return lists_.v.data() + i; }
    float* p(std::size_t i) { return lists_.p.data() + i; }
    float* q(std::size_t i) { return lists_.q.data() + i; }
    float* spread(std::size_t i) { return lists_.spread.data() + i; }
    std::int32_t* pixels_at(std::size_t i) { return lists_.pixel.data() + i; }
    [[nodiscard]] std::size_t pixel(std::size_t i) const {
        return static_cast<std::size_t>(lists_.pixel[i]);
    }
    /// A bit for each of the listed rays from `at` on whose reach is not below its depth.
    [[nodiscard]] LaneBits within_reach(std::size_t at, const std::array<V<double>, 2>& depths) {
        return nearer(depths, hn::LoadU(di, pixels_at(at)));
    }
    void copy(std::size_t from, std::size_t to) {
        lists_.u[to] = lists_.u[from];
        lists_.v[to] = lists_.v[from];
        for (std::vector<float>* const numbers : lists_.floats())
            (*numbers)[to] = (*numbers)[from];
        lists_.pixel[to] = lists_.pixel[from];
    }
    /// Numbers of as many rays as a vector of floats has.
    static HWY_INLINE std::array<V<double>, 2> pair(const double* from) {
        return {hn::LoadU(d<double>, from), hn::LoadU(d<double>, from + lanes<double>)};
    }
    /// The bits of the first lanes, up to all.
    static LaneBits first_bits(std::size_t count) {
        return count >= lanes<float> ? all_lanes<Tag<float>> : (LaneBits{1} << count) - 1;
    }

private:
    static constexpr hn::RebindToSigned<Tag<float>> di{};
    using Pixels = hn::Vec<hn::RebindToSigned<Tag<float>>>;

    /// The bits of two half vectors of lanes: those of call(0) below those of call(1).
    template <class Call>
    static HWY_INLINE LaneBits both_halves(Call call) {
        return bits_of(d<double>, call(0)) | bits_of(d<double>, call(1)) << lanes<double>;
    }
    [[nodiscard]] HWY_INLINE LaneBits nearer(const std::array<V<double>, 2>& depths,
                                             Pixels pixels) const {
        const hn::RebindToSigned<Tag<double>> dl;
        const hn::Rebind<std::int32_t, Tag<double>> half;
        const std::array at{hn::PromoteTo(dl, hn::LowerHalf(half, pixels)),
                            hn::PromoteTo(dl, hn::UpperHalf(half, pixels))};
        return both_halves([&](std::size_t i) HWY_ATTR {
            return hn::Le(depths[i], hn::GatherIndex(d<double>, rays_.reach, at[i]));
        });
    }
    [[nodiscard]] HWY_INLINE LaneBits nearer(double near, Pixels pixels) const {
        return nearer(std::array{number(near), number(near)}, pixels);
    }

    std::size_t list(const QuadraticForm& form, const TileRect& rect, double near,
                     std::size_t count) {
        const auto index = [](int at) { return static_cast<std::size_t>(at); };
        const std::size_t end_col = index(rect.end_col);
        const std::size_t end_row = index(rect.end_row);
        const auto from_first = hn::Iota(di, 0);
        lists_.reserve(count, (end_row - index(rect.row)) * (end_col - index(rect.col)));
        for (std::size_t row = index(rect.row); row < end_row; ++row) {
            for (std::size_t col = index(rect.col); col < end_col; col += lanes<float>) {
                // No vector is read from behind the end of a row.
                const std::size_t from = std::min(col, rays_.row_size - lanes<float>);
                const std::size_t at = row * rays_.row_size + from;
                // List the rays whose reach is not before `near`, unless the form rejects them.
                const auto reach = pair(rays_.reach + at);
                const LaneBits wanted = first_bits(end_col - from) & ~first_bits(col - from) &
                                        both_halves([&](std::size_t i) HWY_ATTR {
                                            return hn::Le(number(near), reach[i]);
                                        });
                if (wanted == 0) continue;
                const auto pixels = hn::Add(from_first, hn::Set(di, static_cast<std::int32_t>(at)));
                count += put(form, lists(), pair(rays_.u + at), pair(rays_.v + at), pixels, wanted,
                             count);
            }
        }
        return count;
    }

    /// Puts a rectangle's pixels in an outline whose reach is not before `near` into the lists.
    std::size_t gather(const PatchOutline& outline, const TileRect& rect, double near,
                       std::size_t count) {
        if (rect.empty()) return count;
        const auto index = [](int at) { return static_cast<std::size_t>(at); };
        lists_.reserve(count, index(rect.end_row - rect.row) * index(rect.end_col - rect.col));
        const auto from_first = hn::Iota(di, 0);
        const V<double> nearest = number(near);
        const Lists to = lists();
        const LeafRays from = rays_;
        for (int row = rect.row; row < rect.end_row; ++row) {
            const ColumnSpan span = outline.span(row, rect);
            if (span.empty()) continue;
            const V<double> v = number(from.v[row]);
            const std::size_t end_col = index(span.end_col);
            for (std::size_t col = index(span.col); col < end_col; col += lanes<float>) {
                // No vector is read from behind the end of a row.
                const std::size_t first = std::min(col, from.row_size - lanes<float>);
                const std::size_t at = index(row) * from.row_size + first;
                const auto reach = pair(from.reach + at);
                const LaneBits wanted =
                    first_bits(end_col - first) & ~first_bits(col - first) &
                    both_halves([&](std::size_t i) HWY_ATTR { return hn::Le(nearest, reach[i]); });
                const auto pixels = hn::Add(from_first, hn::Set(di, static_cast<std::int32_t>(at)));
                to.put_of_row(pair(from.u + first), v, pixels, wanted, count);
                count += static_cast<std::size_t>(std::popcount(wanted));
            }
        }
        return count;
    }

    /// Keeps those of the first `rays` rays of the lists that a form does not reject; returns how
    /// many.
    std::size_t keep_met(const QuadraticForm& form, std::size_t rays) {
        const Lists to = lists();
        std::size_t count = 0;
        for (std::size_t at = 0; at < rays; at += lanes<float>)
            count += put(form, to, pair(to.u + at), pair(to.v + at), hn::LoadU(di, to.pixel + at),
                         first_bits(rays - at), count);
        return count;
    }

    std::size_t list(const QuadraticForm& form, std::span<const std::size_t> pixels, double near,
                     std::size_t count) {
        HWY_ALIGN std::int32_t indices[lanes<float>] = {};
        HWY_ALIGN double us[lanes<float>] = {};
        HWY_ALIGN double vs[lanes<float>] = {};
        lists_.reserve(count, pixels.size());
        for (std::size_t i = 0; i < pixels.size(); i += lanes<float>) {
            const std::size_t some = std::min(lanes<float>, pixels.size() - i);
            for (std::size_t lane = 0; lane < some; ++lane) {
                const std::size_t pixel = pixels[i + lane];
                indices[lane] = static_cast<std::int32_t>(pixel);
                us[lane] = rays_.u[rays_.grid == nullptr ? pixel : pixel % rays_.row_size];
                vs[lane] = rays_.v[rays_.grid == nullptr ? pixel : pixel / rays_.row_size];
            }
            const auto at = hn::Load(di, indices);
            const LaneBits wanted = first_bits(some) & nearer(near, at);
            count += put(form, lists(), pair(us), pair(vs), at, wanted, count);
        }
        return count;
    }

    /// Where the lists begin. Kept by value where rays are put: what is stored might change it
    /// else, as far as compilers know.
    struct Lists {
        double *u, *v;
        float *p, *q, *spread;
        std::int32_t* pixel;

        /// Puts the rays of some lanes there.
        HWY_INLINE void put(const std::array<V<double>, 2>& us, const std::array<V<double>, 2>& vs,
                            Pixels pixels, LaneBits wanted, std::size_t to) const {
            put_pixels(pixels, wanted, to);
            put_halves(us, wanted, u + to);
            put_halves(vs, wanted, v + to);
        }
        /// Puts the rays of some lanes there, which all have the same v.
        HWY_INLINE void put_of_row(const std::array<V<double>, 2>& us, V<double> v_of_all,
                                   Pixels pixels, LaneBits wanted, std::size_t to) const {
            put_pixels(pixels, wanted, to);
            put_halves(us, wanted, u + to);
            hn::StoreU(v_of_all, d<double>, v + to);
            hn::StoreU(v_of_all, d<double>, v + to + lanes<double>);
        }

    private:
        HWY_INLINE void put_pixels(Pixels pixels, LaneBits wanted, std::size_t to) const {
            const V<float> some =
                squeezed(hn::BitCast(d<float>, pixels), mask_of(d<float>, wanted));
            hn::StoreU(hn::BitCast(di, some), di, pixel + to);
        }
        static HWY_INLINE void put_halves(const std::array<V<double>, 2>& numbers, LaneBits wanted,
                                          double* to) {
            constexpr LaneBits lower_bits = all_lanes<Tag<double>>;
            const auto lower = static_cast<std::size_t>(std::popcount(wanted & lower_bits));
            hn::StoreU(squeezed(numbers[0], mask_of(d<double>, wanted & lower_bits)), d<double>,
                       to);
            hn::StoreU(squeezed(numbers[1], mask_of(d<double>, wanted >> lanes<double>)), d<double>,
                       to + lower);
        }
    };
    [[nodiscard]] Lists lists() {
        return {.u = lists_.u.data(),
                .v = lists_.v.data(),
                .p = lists_.p.data(),
                .q = lists_.q.data(),
                .spread = lists_.spread.data(),
                .pixel = lists_.pixel.data()};
    }

    /// Puts those of some rays that are wanted and not rejected into the lists; returns how many.
    static HWY_INLINE std::size_t put(const QuadraticForm& form, const Lists& lists,
                                      const std::array<V<double>, 2>& us,
                                      const std::array<V<double>, 2>& vs, Pixels pixels,
                                      LaneBits wanted, std::size_t to) {
        // Reject rays on which the form has no zero.
        const Zeros zeros =
            form.zeros({.u = floats_of(us[0], us[1]), .v = floats_of(vs[0], vs[1])});
        const LaneBits left_bits = wanted & ~bits_of(d<float>, zeros.none);
        if (left_bits == 0) return 0;
        const M<float> left = mask_of(d<float>, left_bits);
        const V<float> zero = hn::Zero(d<float>);
        // Widen the radius by more than places lose as floats.
        const V<float> sizes =
            hn::Add(number<float>(1.0), hn::Add(hn::Abs(zeros.p), hn::Abs(zeros.q)));
        const V<float> spread = hn::MulAdd(sizes, number<float>(0x1p-20), zeros.radius);
        const V<float> unbounded = number<float>(std::numeric_limits<double>::infinity());
        // Pack the other rays, with where their zeros may be.
        const auto store = [&](V<float> numbers, float* at)
                               HWY_ATTR { hn::StoreU(squeezed(numbers, left), d<float>, at + to); };
        store(hn::IfThenElse(zeros.known, zeros.p, zero), lists.p);
        store(hn::IfThenElse(zeros.known, zeros.q, zero), lists.q);
        store(hn::IfThenElse(zeros.known, spread, unbounded), lists.spread);
        lists.put(us, vs, pixels, left_bits, to);
        return static_cast<std::size_t>(std::popcount(left_bits));
    }

    /// Repeats the last ray in the lanes behind it.
    void repeat_last(std::size_t first, std::size_t count) {
        if (count == 0) return;
        const std::size_t end = first + count;
        for (std::vector<double>* const numbers : {&lists_.u, &lists_.v}) {
            const V<double> last = number((*numbers)[end - 1]);
            hn::StoreU(last, d<double>, numbers->data() + end);
            hn::StoreU(last, d<double>, numbers->data() + end + lanes<double>);
        }
        for (std::vector<float>* const numbers : lists_.floats())
            hn::StoreU(hn::Set(d<float>, (*numbers)[end - 1]), d<float>, numbers->data() + end);
        hn::StoreU(hn::Set(di, lists_.pixel[end - 1]), di, pixels_at(end));
    }

    const SightAxes& axes_;
    const LeafRays& rays_;
    LeafLists& lists_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
