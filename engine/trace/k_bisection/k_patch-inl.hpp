// Which top slices may hold a root for any ray of a patch of pixels, so that the packets of the
// patch need not look at the others one by one.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_K_PATCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_PATCH_INL
#undef ZEROSET_K_PATCH_INL
#else
#define ZEROSET_K_PATCH_INL
#endif

#include "engine/trace/k_bisection/k_batch-inl.hpp"
#include "engine/trace/k_bisection/k_packet_source-inl.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

constexpr int patch_size = 8;  ///< pixels; a multiple of every block's size
constexpr int patches_a_row = tile_size / patch_size;
constexpr int patch_slices = 1 << max_top_depth;  ///< slices looked at; any others may hold a root

/// A line that bounds a coordinate of all rays of a patch: at k, rounded upward.
template <class Real>
struct Edge {
    Real slope, base;
};

/// The top slices of the patches of a tile.
template <class Real>
class PatchSlices {
    static_assert(patch_size % block_cols<Real> == 0 && patch_size % block_rows<Real> == 0);
    static_assert(patch_slices % lanes<Real> == 0);

public:
    PatchSlices(const TraceFrame& frame, const Tile& tile, PacketSource<Real>& source,
                Batch<Real>& batch, Counters& counters);

    /// Bits of the top slices of the packet's patch that may hold a root for a ray of it.
    [[nodiscard]] std::uint64_t of(const Packet<Real>& packet) const {
        const int index = packet.row / patch_size * patches_a_row + packet.col / patch_size;
        const Patch& patch = patches_[static_cast<std::size_t>(index)];
        return patch.axes == packet.axes ? patch.slices : ~0ULL;
    }

private:
    struct Patch {
        const Axes<Real>* axes = nullptr;  ///< nullptr: its rays do not share axes
        std::uint64_t slices = ~0ULL;
        /// Bounds of U and V: -lo from the least slope, hi from the greatest.
        Edge<Real> neg_lo[2], hi[2];
    };

    static Patch patch_of(const Tile& tile, PacketSource<Real>& source, int col, int row);
    static void store_slices(const Patch& patch, std::size_t at, Batch<Real>& batch);
    static std::uint64_t slices_with_roots(std::size_t at, const Batch<Real>& batch);

    std::array<Patch, static_cast<std::size_t>(patches_a_row) * patches_a_row> patches_;
};

/// A bound of the lines with this slope of U over K through some starts; `sign` -1 for -U.
/// `slope_error` bounds the slope's.
template <class Real>
Edge<Real> edge_of(const Axes<Real>& axes, int axis, double slope, double sign,
                   const std::array<glm::dvec3, 4>& starts, double slope_error) {
    const auto near = above<Real>(sign * slope);
    const double narrowing = static_cast<double>(near) - sign * slope;
    // The starts of parallel rays are off by a few roundings of their coordinates.
    const double start_error = axes.parallel ? 0x1p-3 * axes.place_error : 0.0;
    const double error = narrowing * axes.k_size + slope_error * axes.k_reach + start_error;
    double base = -std::numeric_limits<double>::infinity();
    for (const glm::dvec3& start : starts) {
        const double u = axes.mirrored[axis] ? -start[axes.world[axis]] : start[axes.world[axis]];
        const double k = axes.mirrored[0] ? -start[axes.world[0]] : start[axes.world[0]];
        base = std::max(base, sign * u + -k * (sign * slope));
    }
    return {near, above<Real>(base + error)};
}

/// Bounds the lines of a patch by those at its corners, where the slopes of U over K are extreme:
/// they are quotients of affine functions. So are the places where parallel rays pass K = 0, affine
/// functions themselves.
template <class Real>
typename PatchSlices<Real>::Patch PatchSlices<Real>::patch_of(const Tile& tile,
                                                              PacketSource<Real>& source, int col,
                                                              int row) {
    Patch patch;
    const int last_col = std::min(col + patch_size, tile.cols) - 1;
    const int last_row = std::min(row + patch_size, tile.rows) - 1;
    const PacketRays& rays = source.rays();
    const Axes<Real>& axes = source.axes_for(rays.direction.at(col, row));
    double least[2] = {4.0, 4.0};
    double greatest[2] = {0.0, 0.0};
    double shortest = std::numeric_limits<double>::infinity();
    std::array<glm::dvec3, 4> starts;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const int c = (corner & 1U) != 0 ? last_col : col;
        const int r = (corner & 2U) != 0 ? last_row : row;
        starts[corner] = rays.start.at(c, r);
        const glm::dvec3 direction = rays.direction.at(c, r);
        if (&source.axes_for(direction) != &axes) return patch;
        const double k = std::abs(direction[axes.world[0]]);
        shortest = std::min(shortest, k);
        for (int i = 0; i < 2; ++i) {
            const double slope = std::abs(direction[axes.world[i + 1]]) / k;
            least[i] = std::min(least[i], slope);
            greatest[i] = std::max(greatest[i], slope);
        }
    }
    patch.axes = &axes;
    const double slope_error = axes.slope_error_share() / shortest;
    for (int i = 0; i < 2; ++i) {
        patch.neg_lo[i] = edge_of(axes, i + 1, least[i], -1.0, starts, slope_error);
        patch.hi[i] = edge_of(axes, i + 1, greatest[i], 1.0, starts, slope_error);
    }
    return patch;
}

/// Stores the boxes of a patch's first slices, clipped, one a lane, from item `at` of the batch on.
template <class Real>
HWY_INLINE void PatchSlices<Real>::store_slices(const Patch& patch, std::size_t at,
                                                Batch<Real>& batch) {
    const Axes<Real>& axes = *patch.axes;
    Real* const ends = batch.ends[0] + at;
    const V<Real> unit = hn::Set(d<Real>, axes.unit);
    const V<Real> origin = hn::Set(d<Real>, axes.origin);
    for (std::size_t s = 0; s < patch_slices; s += lanes<Real>) {
        // K, from slice to slice.
        const V<Real> index = hn::Mul(hn::Iota(d<Real>, static_cast<Real>(s)),
                                      hn::Set(d<Real>, static_cast<Real>(axes.slice_cells)));
        const V<Real> next = hn::Add(index, hn::Set(d<Real>, static_cast<Real>(axes.slice_cells)));
        const V<Real> from = hn::Add(origin, hn::Mul(index, unit));
        const V<Real> to = hn::Add(origin, hn::Mul(next, unit));
        hn::StoreU(hn::Neg(from), d<Real>, ends + axes.from_offset[0] + s);
        hn::StoreU(to, d<Real>, ends + axes.to_offset[0] + s);
        // U and V, by the patch's edges, no larger than the clip box.
        for (int i = 0; i < 2; ++i) {
            const Edge<Real>& neg_lo = patch.neg_lo[i];
            const Edge<Real>& hi = patch.hi[i];
            const V<Real> u_neg_lo =
                hn::MulAdd(hn::Set(d<Real>, neg_lo.slope), from, hn::Set(d<Real>, neg_lo.base));
            const V<Real> u_hi =
                hn::MulAdd(hn::Set(d<Real>, hi.slope), to, hn::Set(d<Real>, hi.base));
            hn::StoreU(hn::Min(u_neg_lo, hn::Set(d<Real>, axes.neg_lo[i + 1])), d<Real>,
                       ends + axes.from_offset[i + 1] + s);
            hn::StoreU(hn::Min(u_hi, hn::Set(d<Real>, axes.hi[i + 1])), d<Real>,
                       ends + axes.to_offset[i + 1] + s);
        }
    }
}

/// Bits of the slices from item `at` on where the box is not empty and F does not exclude 0.
template <class Real>
std::uint64_t PatchSlices<Real>::slices_with_roots(std::size_t at, const Batch<Real>& batch) {
    std::uint64_t bits = ~0ULL << patch_slices;
    for (std::size_t s = 0; s < patch_slices; ++s) {
        bool empty = false;
        for (int i = 0; i < 3; ++i) {
            empty = empty || batch.ends[i][at + s] + batch.ends[i + 3][at + s] < 0;
        }
        const bool rejected = batch.f_neg_lo[at + s] < 0 || batch.f_hi[at + s] < 0;
        if (!empty && !rejected) bits |= 1ULL << s;
    }
    return bits;
}

template <class Real>
PatchSlices<Real>::PatchSlices(const TraceFrame& frame, const Tile& tile,
                               PacketSource<Real>& source, Batch<Real>& batch, Counters& counters) {
    constexpr std::size_t at_once = batch_capacity<Real> / patch_slices;
    for (std::size_t first = 0; first < patches_.size(); first += at_once) {
        for (std::size_t i = first; i < first + at_once; ++i) {
            const int col = static_cast<int>(i) % patches_a_row * patch_size;
            const int row = static_cast<int>(i) / patches_a_row * patch_size;
            if (col >= tile.cols || row >= tile.rows) continue;
            if (counters.costs != nullptr)
                counters.costs->add(col, row, patch_size, patch_size, patch_slices);
            patches_[i] = patch_of(tile, source, col, row);
            if (patches_[i].axes == nullptr) continue;
            store_slices(patches_[i], (i - first) * patch_slices, batch);
        }
        batch.evaluate(frame, batch_capacity<Real> / lanes<Real>, counters);
        for (std::size_t i = first; i < first + at_once; ++i) {
            if (patches_[i].axes == nullptr) continue;
            patches_[i].slices = slices_with_roots((i - first) * patch_slices, batch);
        }
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
