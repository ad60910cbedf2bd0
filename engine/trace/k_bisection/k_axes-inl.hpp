// The axes of packets for the directions of a frame.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_K_AXES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_AXES_INL
#undef ZEROSET_K_AXES_INL
#else
#define ZEROSET_K_AXES_INL
#endif

#include "engine/real/scalar.hpp"
#include "engine/trace/k_bisection/k_packet-inl.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A vector for each pixel of a tile.
struct PixelVectors {
    glm::dvec3 first;
    glm::dvec3 by_col{0.0}, by_row{0.0};

    [[nodiscard]] glm::dvec3 at(int col, int row) const {
        return first + static_cast<double>(col) * by_col + static_cast<double>(row) * by_row;
    }
};

/// The rays of a tile's pixels. Those of a perspective view start at the eye, parallel ones on a
/// plane across the view before the clip box, so that nothing is behind their starts.
struct PacketRays {
    PixelVectors start, direction;
    double start_depth = 0.0;  ///< of the starts, from the plane through the eye

    PacketRays(const TraceFrame& frame, const Tile& tile);
};

inline PacketRays::PacketRays(const TraceFrame& frame, const Tile& tile) {
    const ViewFrame& view = frame.view;
    const PixelPoint at = pixel_centre(tile.col, tile.row);
    const double size = view.pixel_size(frame.image.height);
    direction.first = view.direction(at, frame.image);
    start.first = view.eye;
    if (!view.parallel()) {
        direction.by_col = size * view.right;
        direction.by_row = -size * view.up;
        return;
    }
    const Box& clip = frame.scene.clip;
    const glm::dvec3 nearest =
        glm::mix(clip.hi, clip.lo, glm::greaterThan(view.forward, glm::dvec3(0.0)));
    start_depth = glm::dot(nearest - view.eye, view.forward) - 2.0 * place_error(frame);
    start.first = view.origin(at, frame.image) + start_depth * view.forward;
    start.by_col = size * view.look_distance * view.right;
    start.by_row = -size * view.look_distance * view.up;
}

/// The least number of the type that is not below `value`.
template <class Real>
Real above(double value) {
    return upper_end(Real{}, value);
}

/// Makes the axes that rays of a frame need, each once.
template <class Real>
class AxesTable {
public:
    AxesTable(const TraceFrame& frame, const PacketRays& rays) : frame_(frame), rays_(rays) {}
    /// The axes for a ray; they live as long as the table.
    HWY_INLINE const Axes<Real>& of(const glm::dvec3& direction);

private:
    HWY_NOINLINE void make(Axes<Real>& axes, int k, const glm::bvec3& negative) const;
    void set_axis(Axes<Real>& axes, int i, int world, bool mirrored) const;
    void set_grid(Axes<Real>& axes) const;

    const TraceFrame& frame_;
    const PacketRays& rays_;
    Axes<Real> axes_[24];     ///< by dominant axis and signs of the direction
    std::uint32_t made_ = 0;  ///< bits of the axes that are made
};

template <class Real>
HWY_INLINE const Axes<Real>& AxesTable<Real>::of(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    const int longest_of_xy = size.x >= size.y ? 0 : 1;
    const int k = size[longest_of_xy] >= size.z ? longest_of_xy : 2;
    const glm::bvec3 negative(direction.x < 0, direction.y < 0, direction.z < 0);
    const int key = 8 * k + (negative.x ? 1 : 0) + (negative.y ? 2 : 0) + (negative.z ? 4 : 0);
    Axes<Real>& axes = axes_[key];
    if ((made_ >> key & 1U) == 0) {
        make(axes, k, negative);
        made_ |= 1U << key;
    }
    return axes;
}

template <class Real>
HWY_NOINLINE void AxesTable<Real>::make(Axes<Real>& axes, int k, const glm::bvec3& negative) const {
    for (int i = 0; i < 3; ++i) {
        const int world = (k + i) % 3;
        set_axis(axes, i, world, negative[world]);
    }
    const double half_height = frame_.view.half_height;
    const double half_width = half_height * frame_.image.width / frame_.image.height;
    // Twice what k_rays-inl.hpp derives; of parallel rays, what covers the roundings of slopes.
    axes.direction_error =
        frame_.view.parallel() ? 0x1p-50 : 0x1p-47 * (1.0 + half_width + half_height);
    const double lo = frame_.scene.clip.lo[k];
    const double hi = frame_.scene.clip.hi[k];
    axes.k_size = std::max(std::abs(lo), std::abs(hi));
    axes.region = &frame_.scene.region;
    axes.place_error = place_error(frame_);
    axes.parallel = frame_.view.parallel();
    axes.start_depth = rays_.start_depth;
    const double apart = std::abs(rays_.start.by_col[k]) + std::abs(rays_.start.by_row[k]);
    axes.k_reach = std::max(std::abs(axes.from_lo[0]), std::abs(axes.to_hi[0])) + tile_size * apart;
    set_grid(axes);
}

template <class Real>
void AxesTable<Real>::set_axis(Axes<Real>& axes, int i, int world, bool mirrored) const {
    const Box& clip = frame_.scene.clip;
    const double sign = mirrored ? -1.0 : 1.0;
    const double lo = mirrored ? -clip.hi[world] : clip.lo[world];
    const double hi = mirrored ? -clip.lo[world] : clip.hi[world];
    const std::size_t neg_lo_offset = static_cast<std::size_t>(world) * batch_capacity<Real>;
    const std::size_t hi_offset = neg_lo_offset + 3 * batch_capacity<Real>;
    axes.world[i] = world;
    axes.mirrored[i] = mirrored;
    axes.from_offset[i] = mirrored ? hi_offset : neg_lo_offset;
    axes.to_offset[i] = mirrored ? neg_lo_offset : hi_offset;
    const double start = sign * rays_.start.first[world];
    axes.from_lo[i] = start - lo;
    axes.to_hi[i] = hi - start;
    axes.box_lo[i] = lo;
    axes.box_hi[i] = hi;
    axes.neg_lo[i] = above<Real>(-lo);
    axes.hi[i] = above<Real>(hi);
    const PixelVectors& steps = frame_.view.parallel() ? rays_.start : rays_.direction;
    for (std::size_t lane = 0; lane < lanes<Real>; ++lane) {
        const auto col = static_cast<double>(lane % block_cols<Real>);
        const auto row = static_cast<double>(lane / block_cols<Real>);
        axes.lane_offset[i][lane] = sign * (col * steps.by_col[world] + row * steps.by_row[world]);
    }
}

template <class Real>
void AxesTable<Real>::set_grid(Axes<Real>& axes) const {
    const double size = frame_.scene.clip.size();
    const SearchDepth& search = frame_.depth;
    const int possible =
        deepest_halving(frame_.scene.clip, axes.k_size, std::numeric_limits<Real>::digits);
    const int depth = std::max(1, std::min(search.wanted, possible));
    axes.certifies = search.wanted - depth <= most_missed_halvings;
    const int top_depth = std::min(max_top_depth, depth - 1);
    axes.unit = above<Real>(std::ldexp(size, -depth));
    axes.origin = -axes.neg_lo[0];
    axes.slice_cells = std::int64_t{1} << (depth - top_depth);
    const Real slice = axes.unit * static_cast<Real>(axes.slice_cells);
    const Real extent = axes.hi[0] - axes.origin;
    axes.slice_count = static_cast<int>(std::floor(extent / slice)) + 1;
    // Where every slice has the same limit, or a limit of the packet's own, coarser ones do not
    // occur.
    const bool by_distance =
        search.deeper > 0 && frame_.stop.rule != StopRule::Epsilon && !axes.parallel;
    axes.coarsest = by_distance ? std::int64_t{2} << std::min(search.deeper, depth) : 2;
    axes.near_shift = std::max(0, depth - search.deeper);
    const double cells_to_eye = by_distance ? axes.from_lo[0] / static_cast<double>(axes.unit) : 0;
    axes.eye_cell = static_cast<std::int64_t>(std::clamp(cells_to_eye, -0x1p60, 0x1p60));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
