// What is proved of whole pixels, not only of the rays through their centres.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_COVER_MARKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_COVER_MARKS_INL
#undef ZEROSET_COVER_MARKS_INL
#else
#define ZEROSET_COVER_MARKS_INL
#endif

#include "engine/real/scalar.hpp"
#include "engine/trace/simd/vectors-inl.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// For each pixel of a tile, the nearest sheet that covers all of it, and where something else may
/// be.
template <class Real>
class CoverMarks {
public:
    /// Begins a tile in which cells hold all rays of their pixels, and marks go to `out`; else
    /// nothing is marked.
    void begin(bool wanted, PixelCover& out) {
        out_ = wanted ? &out : nullptr;
        if (!wanted) return;
        out.clear();
        if constexpr (std::is_same_v<Real, float>) {
            from_ = out.from.data();
            to_ = out.to.data();
            other_from_ = out.other_from.data();
            other_to_ = out.other_to.data();
            rest_from_ = out.rest_from.data();
        } else {
            const std::size_t pixels = out.from.size();
            own_.assign(5 * pixels, none);
            from_ = own_.data();
            to_ = from_ + pixels;
            other_from_ = to_ + pixels;
            rest_from_ = other_from_ + pixels;
            other_to_ = rest_from_ + pixels;
            std::fill_n(other_to_, pixels, -none);
        }
    }
    [[nodiscard]] bool wanted() const { return out_ != nullptr; }
    /// Of the pixels from `pixel` on those in `some` may hold roots between `from` and `to`; on all
    /// rays of those in `covered`, which are among them, is one there.
    template <class D>
    HWY_INLINE void mark(D tag, std::size_t pixel, hn::Vec<D> from, hn::Vec<D> to, hn::Mask<D> some,
                         hn::Mask<D> covered) {
        out_->marked = true;
        const auto old_from = hn::LoadU(tag, &from_[pixel]);
        const auto old_to = hn::LoadU(tag, &to_[pixel]);
        const auto nearer = hn::And(covered, hn::Lt(to, old_to));
        hn::StoreU(hn::IfThenElse(nearer, from, old_from), tag, &from_[pixel]);
        hn::StoreU(hn::IfThenElse(nearer, to, old_to), tag, &to_[pixel]);
        // What is not the nearest sheet, if there is something.
        const auto nowhere = hn::Inf(tag);
        const auto lo = hn::IfThenElse(nearer, old_from, hn::IfThenElse(some, from, nowhere));
        const auto is_there = hn::Lt(lo, nowhere);
        if (hn::AllFalse(tag, is_there)) return;
        const auto hi = hn::IfThenElse(is_there, hn::IfThenElse(nearer, old_to, to), nowhere);
        add_others(tag, pixel, lo, hi);
    }
    /// Between two depths f is continuous on the rays of a pixel, and may be 0.
    void open(std::size_t pixel, Real from, Real to) {
        out_->marked = true;
        add_others(hn::CappedTag<Real, 1>(), pixel, hn::Set(hn::CappedTag<Real, 1>(), from),
                   hn::Set(hn::CappedTag<Real, 1>(), to));
    }
    /// From a depth on nothing is known of a pixel.
    void leave(std::size_t pixel, double from) {
        if (out_ == nullptr) return;
        out_->marked = true;
        rest_from_[pixel] = std::min(rest_from_[pixel], -upper_end(Real{}, -from));
    }
    /// Behind a depth nobody has looked at a block of pixels.
    void end_block(std::size_t at, Real looked_to) { out_->looked_to[at] = below(looked_to); }
    void end() {
        if constexpr (!std::is_same_v<Real, float>) {
            if (out_ == nullptr || !out_->marked) return;
            for (std::size_t pixel = 0; pixel < out_->from.size(); ++pixel) {
                out_->from[pixel] = below(from_[pixel]);
                out_->to[pixel] = float_above(to_[pixel]);
                out_->other_from[pixel] = below(other_from_[pixel]);
                out_->other_to[pixel] = float_above(other_to_[pixel]);
                out_->rest_from[pixel] = below(rest_from_[pixel]);
            }
        }
    }

private:
    static constexpr Real none = std::numeric_limits<Real>::infinity();

    static float below(Real depth) { return -float_above(-depth); }
    /// Joins stretches to the nearest ones of others, or puts what is farther to the rest.
    template <class D>
    HWY_INLINE void add_others(D tag, std::size_t pixel, hn::Vec<D> lo, hn::Vec<D> hi) {
        const auto from = hn::LoadU(tag, &other_from_[pixel]);
        const auto to = hn::LoadU(tag, &other_to_[pixel]);
        const auto before = hn::Lt(hi, from);
        const auto behind = hn::Gt(lo, to);
        const auto farther = hn::IfThenElse(before, from, hn::IfThenElse(behind, lo, hn::Inf(tag)));
        const auto joined = hn::IfThenElse(behind, to, hn::Max(to, hi));
        hn::StoreU(hn::Min(hn::LoadU(tag, &rest_from_[pixel]), farther), tag, &rest_from_[pixel]);
        hn::StoreU(hn::Min(from, lo), tag, &other_from_[pixel]);
        hn::StoreU(hn::IfThenElse(before, hi, joined), tag, &other_to_[pixel]);
    }

    PixelCover* out_ = nullptr;  ///< nullptr: nothing is wanted
    Real* from_ = nullptr;
    Real* to_ = nullptr;
    Real* other_from_ = nullptr;
    Real* other_to_ = nullptr;
    Real* rest_from_ = nullptr;
    std::vector<Real> own_;  ///< depths that have no place in `out_`
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
