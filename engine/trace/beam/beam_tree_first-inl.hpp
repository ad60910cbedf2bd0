// The first cells of a tile: slabs of all of it, or of what the parts of a union cover.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_TREE_FIRST_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_TREE_FIRST_INL
#undef ZEROSET_BEAM_TREE_FIRST_INL
#else
#define ZEROSET_BEAM_TREE_FIRST_INL
#endif

#include "engine/real/scalar.hpp"
#include "engine/trace/beam/beam_tree-inl.hpp"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real>
void CellTree<Real>::begin(int pixels) {
    for (const UnionMember& part : frame_.union_members) {
        if (first_pixels(part) == pixels) push_part(part, pixels);
    }
    if (!frame_.union_members.empty() || pixels != tile_size) return;
    push_first({.kernel = &frame_.kernel,
                .col = 0,
                .row = 0,
                .from = depths_.enter_lo,
                .to = depths_.exit_hi,
                .slabs = first_slabs},
               depths_);
}

template <class Real>
void CellTree<Real>::push_first(const First& first, const DepthRange& depths) {
    cells_->runs.begin(first.kernel, cells_->size);
    cells_->reserve(static_cast<std::size_t>(first.slabs));
    const Real near = -upper_end(Real{}, -first.from);
    const Real far = upper_end(Real{}, first.to);
    Real from = near;
    for (int i = 1; i <= first.slabs; ++i) {
        const Real part = static_cast<Real>(i) / static_cast<Real>(first.slabs);
        const Real to = i == first.slabs ? far : near + (far - near) * part;
        const bool inside = static_cast<double>(from) >= depths.enter_hi &&
                            static_cast<double>(to) <= depths.exit_lo;
        cells_->push(CellTile::at(first.col, first.row, inside), from, to);
        from = to;
    }
}

template <class Real>
auto CellTree<Real>::tiles_of(const UnionMember& part, int pixels) const -> Tiles {
    const auto tile_at = [&](double place, int begin, int count) {
        return static_cast<int>(std::clamp(place - begin, 0.0, count - 1.0)) / pixels;
    };
    return {.first_col = tile_at(part.first_col, tile_.col, tile_.cols),
            .last_col = tile_at(part.last_col, tile_.col, tile_.cols),
            .first_row = tile_at(part.first_row, tile_.row, tile_.rows),
            .last_row = tile_at(part.last_row, tile_.row, tile_.rows)};
}

template <class Real>
int CellTree<Real>::first_pixels(const UnionMember& part) const {
    constexpr int most_tiles = 12;  // with some slabs they are about a batch
    int pixels = tile_size;
    while (pixels > leaf_pixels && tiles_of(part, pixels / 2).count() <= most_tiles)
        pixels /= 2;
    return pixels;
}

template <class Real>
void CellTree<Real>::push_part(const UnionMember& part, int pixels) {
    const double from = std::max(part.from, depths_.enter_lo);
    const double to = std::min(part.to, depths_.exit_hi);
    if (!(from <= to)) return;
    const bool inside = from >= depths_.enter_hi && to <= depths_.exit_lo;
    const double width = rays_.pixel() * pixels * (rays_.distance() + from);
    const int slabs = static_cast<int>(std::clamp((to - from) / width + 0.5, 1.0, most_slabs));
    const Tiles tiles = tiles_of(part, pixels);
    for (int row = tiles.first_row * pixels; row <= tiles.last_row * pixels; row += pixels) {
        for (int col = tiles.first_col * pixels; col <= tiles.last_col * pixels; col += pixels) {
            const DepthRange depths = inside ? depths_ : depths_of(col, row, pixels);
            const double begin = std::max(from, depths.enter_lo);
            const double end = std::min(to, depths.exit_hi);
            if (!(begin <= end)) continue;
            push_first({.kernel = part.kernel,
                        .col = col,
                        .row = row,
                        .from = begin,
                        .to = end,
                        .slabs = slabs},
                       depths);
        }
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
