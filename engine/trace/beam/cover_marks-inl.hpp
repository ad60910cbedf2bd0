// Marks of what is proved of whole pixels, not only of the rays through their centres.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_COVER_MARKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_COVER_MARKS_INL
#undef ZEROSET_COVER_MARKS_INL
#else
#define ZEROSET_COVER_MARKS_INL
#endif

#include "engine/real/lanes-inl.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// For each pixel of a tile, the nearest sheet that covers all of it, and where something else may
/// be first and last.
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
            last_ = out.last.data();
        } else {
            own_.assign(3 * out.from.size(), std::numeric_limits<Real>::infinity());
            own_.resize(4 * out.from.size(), -std::numeric_limits<Real>::infinity());
            from_ = own_.data();
            to_ = from_ + out.from.size();
            other_from_ = to_ + out.from.size();
            last_ = other_from_ + out.from.size();
        }
    }
    [[nodiscard]] bool wanted() const { return out_ != nullptr; }
    /// Whether something is marked in the block of a pixel.
    [[nodiscard]] bool is_marked(std::size_t pixel) const { return out_->is_marked(pixel); }
    /// Marks the block of a pixel; `covered`: a sheet covers each marked pixel of the block.
    void mark_block(std::size_t pixel, bool covered) {
        if (covered) return out_->mark_covered(pixel);
        out_->mark(pixel);
    }
    /// Marks pixels from `pixel` on, in a block that the caller marks: those in `some` may hold
    /// roots between `from` and `to`; on all rays of those in `covered`, which are among them, is
    /// one there.
    template <class D>
    HWY_INLINE void mark(D tag, std::size_t pixel, hn::Vec<D> from, hn::Vec<D> to, hn::Mask<D> some,
                         hn::Mask<D> covered) {
        const auto old_from = hn::LoadU(tag, &from_[pixel]);
        const auto old_to = hn::LoadU(tag, &to_[pixel]);
        const auto nearer = hn::And(covered, hn::Lt(to, old_to));
        const auto none = hn::Inf(tag);
        const auto displaced = hn::IfThenElse(nearer, old_from, hn::IfThenElse(some, from, none));
        hn::StoreU(hn::Min(hn::LoadU(tag, &other_from_[pixel]), displaced), tag,
                   &other_from_[pixel]);
        hn::StoreU(hn::IfThenElse(nearer, from, old_from), tag, &from_[pixel]);
        hn::StoreU(hn::IfThenElse(nearer, to, old_to), tag, &to_[pixel]);
        hn::StoreU(hn::IfThenElse(some, hn::Max(hn::LoadU(tag, &last_[pixel]), to),
                                  hn::LoadU(tag, &last_[pixel])),
                   tag, &last_[pixel]);
    }
    /// Marks pixels as `mark` does, in a block in which nothing is marked so far.
    template <class D>
    HWY_INLINE void mark_first(D tag, std::size_t pixel, hn::Vec<D> from, hn::Vec<D> to,
                               hn::Mask<D> some, hn::Mask<D> covered) {
        const auto none = hn::Inf(tag);
        hn::StoreU(hn::IfThenElse(covered, from, none), tag, &from_[pixel]);
        hn::StoreU(hn::IfThenElse(covered, to, none), tag, &to_[pixel]);
        hn::StoreU(hn::IfThenElse(hn::AndNot(covered, some), from, none), tag, &other_from_[pixel]);
        // Leave the last depth unknown behind a sheet: not all is searched there.
        const auto last = hn::IfThenElse(covered, none, to);
        hn::StoreU(hn::IfThenElse(some, last, hn::Neg(none)), tag, &last_[pixel]);
    }
    /// Marks pixels from `pixel` on of a row in a block of a tile: between two depths nothing is
    /// known of those in `some`.
    template <class D>
    HWY_INLINE void leave(D tag, std::size_t pixel, hn::Vec<D> from, hn::Vec<D> to,
                          hn::Mask<D> some) {
        out_->mark(pixel);
        const auto least = hn::Min(hn::LoadU(tag, &other_from_[pixel]), from);
        const auto most = hn::Max(hn::LoadU(tag, &last_[pixel]), to);
        hn::StoreU(hn::IfThenElse(some, least, hn::LoadU(tag, &other_from_[pixel])), tag,
                   &other_from_[pixel]);
        hn::StoreU(hn::IfThenElse(some, most, hn::LoadU(tag, &last_[pixel])), tag, &last_[pixel]);
    }
    /// Between two depths nothing is known of a pixel.
    void leave(std::size_t pixel, double from, double to) {
        if (out_ == nullptr) return;
        out_->mark(pixel);
        other_from_[pixel] = std::min(other_from_[pixel], -upper_end(Real{}, -from));
        last_[pixel] = std::max(last_[pixel], upper_end(Real{}, to));
    }
    /// Ends a tile; `nearest`: the roots on the pixels' own rays, behind which not all was
    /// searched.
    void end(const Real* nearest) {
        if (out_ == nullptr) return;
        for_each_block_row(out_->open_blocks, [&](std::size_t first) {
            constexpr Real none = std::numeric_limits<Real>::infinity();
            for (std::size_t pixel = first; pixel < first + tile_block; ++pixel)
                last_[pixel] = nearest[pixel] < none ? none : last_[pixel];
        });
        if constexpr (!std::is_same_v<Real, float>) {
            const auto below = [](Real depth) { return -float_above(-depth); };
            for_each_block_row(out_->blocks, [&](std::size_t first) {
                for (std::size_t pixel = first; pixel < first + tile_block; ++pixel) {
                    out_->from[pixel] = below(from_[pixel]);
                    out_->to[pixel] = float_above(to_[pixel]);
                    out_->other_from[pixel] = below(other_from_[pixel]);
                    out_->last[pixel] = float_above(last_[pixel]);
                }
            });
        }
    }

private:
    PixelCover* out_ = nullptr;  ///< nullptr: nothing is wanted
    Real* from_ = nullptr;
    Real* to_ = nullptr;
    Real* other_from_ = nullptr;
    Real* last_ = nullptr;
    std::vector<Real> own_;  ///< depths that have no place in `out_`
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
