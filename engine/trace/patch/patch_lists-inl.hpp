// Lists of the rays that may meet a leaf, and of those that may meet pieces of it.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_PATCH_LISTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_PATCH_LISTS_INL
#undef ZEROSET_PATCH_LISTS_INL
#else
#define ZEROSET_PATCH_LISTS_INL
#endif

#include "engine/trace/patch/patch_pieces-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Some rays of the lists: from `first` on.
struct Range {
    std::size_t first, count;
};

/// The rays of a leaf that may meet some part of it, one list behind the other.
class RayLists {
public:
    RayLists(const SightAxes& axes, const LeafRays& rays, LeafLists& lists)
        : axes_(axes), rays_(rays), lists_(lists) {}

    /// Lists the rays through some pixels that may meet a piece.
    Range list(const Piece& piece, const LeafPixels& pixels) {
        const LinearForm form(piece.sight, axes_);
        const double near = piece.sight.depths().near;
        std::size_t count = 0;
        for (const TileRect& rect : pixels.rects)
            count = list(form, rect, near, count);
        count = list(form, pixels.others, near, count);
        repeat_last(0, count);
        return {.first = 0, .count = count};
    }

    /// Lists those rays again, behind them, that the piece's linear form does not reject, with
    /// where it has their zeros.
    Range list(const Piece& piece, const Range& rays) {
        const D d;
        const hn::RebindToSigned<D> di;
        const LinearForm form(piece.sight, axes_);
        const double near = piece.sight.depths().near;
        const std::size_t first = rays.first + rays.count;
        lists_.reserve(first, rays.count + width);
        std::size_t count = 0;
        for (std::size_t i = 0; i < rays.count; i += width) {
            const std::size_t at = rays.first + i;
            const Mask real = hn::FirstN(d, rays.count - i);
            const auto pixel = hn::IfThenElseZero(hn::RebindMask(di, real),
                                                  hn::LoadU(di, lists_.pixel.data() + at));
            const Vector reach = hn::GatherIndex(d, rays_.reach, pixel);
            const Mask wanted = hn::And(real, hn::Le(number(near), reach));
            if (hn::AllFalse(d, wanted)) continue;
            count += put(form, hn::LoadU(d, u(at)), hn::LoadU(d, v(at)), hn::BitCast(d, pixel),
                         wanted, first + count);
        }
        repeat_last(first, count);
        return {.first = first, .count = count};
    }

    /// Rays that surround those of the list.
    SightRays bounds_of(const Range& rays) {
        const D d;
        Vector u_lo = hn::LoadU(d, u(rays.first));
        Vector v_lo = hn::LoadU(d, v(rays.first));
        Vector u_hi = u_lo;
        Vector v_hi = v_lo;
        for (std::size_t i = width; i < rays.count; i += width) {
            const Vector us = hn::LoadU(d, u(rays.first + i));
            const Vector vs = hn::LoadU(d, v(rays.first + i));
            u_lo = hn::Min(u_lo, us);
            u_hi = hn::Max(u_hi, us);
            v_lo = hn::Min(v_lo, vs);
            v_hi = hn::Max(v_hi, vs);
        }
        const auto range = [&](Vector lo, Vector hi) HWY_ATTR {
            const double least = hn::GetLane(hn::MinOfLanes(d, lo));
            const double most = hn::GetLane(hn::MaxOfLanes(d, hi));
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
    double* p(std::size_t i) { return lists_.p.data() + i; }
    double* q(std::size_t i) { return lists_.q.data() + i; }
    double* spread(std::size_t i) { return lists_.spread.data() + i; }
    std::int64_t* pixels(std::size_t i) { return lists_.pixel.data() + i; }
    [[nodiscard]] std::size_t pixel(std::size_t i) const {
        return static_cast<std::size_t>(lists_.pixel[i]);
    }
    void copy(std::size_t from, std::size_t to) {
        for (std::vector<double>* const numbers : lists_.numbers())
            (*numbers)[to] = (*numbers)[from];
        lists_.pixel[to] = lists_.pixel[from];
    }

private:
    std::size_t list(const LinearForm& form, const TileRect& rect, double near, std::size_t count) {
        const D d;
        const hn::RebindToSigned<D> di;
        const auto col_of = [](int col) { return static_cast<std::size_t>(col); };
        const std::size_t first_col = col_of(rect.col) / width * width;
        const std::size_t end_col = col_of(rect.end_col);
        const std::size_t end_row = col_of(rect.end_row);
        lists_.reserve(count, (end_row - col_of(rect.row)) * (end_col + width));
        for (std::size_t row = col_of(rect.row); row < end_row; ++row) {
            for (std::size_t col = first_col; col < end_col; col += width) {
                const std::size_t at = row * rays_.row_size + col;
                Mask wanted = hn::And(hn::Le(number(near), hn::LoadU(d, rays_.reach + at)),
                                      hn::FirstN(d, end_col - col));
                if (col < col_of(rect.col))
                    wanted = hn::AndNot(hn::FirstN(d, col_of(rect.col) - col), wanted);
                if (hn::AllFalse(d, wanted)) continue;
                const auto pixel = hn::Iota(di, static_cast<std::int64_t>(at));
                count += put(form, hn::LoadU(d, rays_.u + at), hn::LoadU(d, rays_.v + at),
                             hn::BitCast(d, pixel), wanted, count);
            }
        }
        return count;
    }

    std::size_t list(const LinearForm& form, std::span<const std::size_t> pixels, double near,
                     std::size_t count) {
        const D d;
        const hn::RebindToSigned<D> di;
        HWY_ALIGN std::int64_t indices[width] = {};
        lists_.reserve(count, pixels.size() + width);
        for (std::size_t i = 0; i < pixels.size(); i += width) {
            const std::size_t some = std::min(width, pixels.size() - i);
            for (std::size_t lane = 0; lane < some; ++lane)
                indices[lane] = static_cast<std::int64_t>(pixels[i + lane]);
            const auto pixel = hn::Load(di, indices);
            const Mask wanted = hn::And(
                hn::FirstN(d, some), hn::Le(number(near), hn::GatherIndex(d, rays_.reach, pixel)));
            count += put(form, hn::GatherIndex(d, rays_.u, pixel),
                         hn::GatherIndex(d, rays_.v, pixel), hn::BitCast(d, pixel), wanted, count);
        }
        return count;
    }

    /// Puts those of some rays that are wanted and not rejected into the lists; returns how many.
    HWY_INLINE std::size_t put(const LinearForm& form, Vector us, Vector vs, Vector pixels,
                               Mask wanted, std::size_t to) {
        const D d;
        const hn::RebindToSigned<D> di;
        const Zeros zeros = form.zeros(us, vs);
        const Mask left = hn::AndNot(zeros.none, wanted);
        const std::size_t some = hn::CountTrue(d, left);
        if (some == 0) return 0;
        const Vector zero = number(0.0);
        hn::StoreU(squeezed(us, left), d, u(to));
        hn::StoreU(squeezed(vs, left), d, v(to));
        hn::StoreU(squeezed(hn::IfThenElse(zeros.known, zeros.p, zero), left), d, p(to));
        hn::StoreU(squeezed(hn::IfThenElse(zeros.known, zeros.q, zero), left), d, q(to));
        // More than places lose as floats.
        const Vector sizes = hn::Add(number(1.0), hn::Add(hn::Abs(zeros.p), hn::Abs(zeros.q)));
        const Vector spread = hn::MulAdd(sizes, number(0x1p-20), zeros.radius);
        const Vector unbounded = number(std::numeric_limits<double>::infinity());
        hn::StoreU(squeezed(hn::IfThenElse(zeros.known, spread, unbounded), left), d,
                   lists_.spread.data() + to);
        hn::StoreU(hn::BitCast(di, squeezed(pixels, left)), di, lists_.pixel.data() + to);
        return some;
    }

    /// Lanes behind the last ray repeat it.
    void repeat_last(std::size_t first, std::size_t count) {
        if (count == 0) return;
        const D d;
        const std::size_t end = first + count;
        for (std::vector<double>* const numbers : lists_.numbers()) {
            const Vector last = number((*numbers)[end - 1]);
            hn::StoreU(last, d, numbers->data() + end);
            hn::StoreU(last, d, numbers->data() + end + width);
        }
        const hn::RebindToSigned<D> di;
        const auto last = hn::Set(di, lists_.pixel[end - 1]);
        hn::StoreU(last, di, lists_.pixel.data() + end);
        hn::StoreU(last, di, lists_.pixel.data() + end + width);
    }

    const SightAxes& axes_;
    const LeafRays& rays_;
    LeafLists& lists_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
