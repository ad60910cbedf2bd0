#include "engine/trace/ray_lines.hpp"

#include "engine/scene/tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {

void RayLines::set_cells(const TraceFrame& frame, int digits) {
    const Box& clip = frame.scene.clip;
    const SearchDepth& search = frame.depth;
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = std::max(std::abs(clip.lo[axis]), std::abs(clip.hi[axis]));
        const int depth =
            std::max(1, std::min(search.wanted, deepest_halving(clip, reach, digits)));
        const auto at = static_cast<std::size_t>(axis);
        cell_[at] = std::ldexp(clip.size(), -depth);
        certifies_[at] = search.wanted - depth <= most_missed_halvings;
    }
    epsilon_ = frame.stop.rule == StopRule::Epsilon ? frame.stop.value : 0.0;
    grows_ = search.deeper > 0 && epsilon_ == 0.0 && !frame.view.parallel();
    look_distance_ = frame.view.look_distance;
    growth_ = std::ldexp(1.0, search.deeper - search.wanted);
    most_growth_ = std::ldexp(1.0, std::min(search.deeper, search.wanted));
}

double RayLines::finest(const RayLine& line, double s) const {
    const double cell = cell_[line.axis] * line.per_size;
    if (epsilon_ > 0.0) {
        const double length = std::hypot(line.direction[0], line.direction[1], line.direction[2]);
        return std::max(cell, epsilon_ / length);
    }
    if (!grows_) return cell;
    return std::max(cell, std::min((look_distance_ + s) * growth_, most_growth_ * cell));
}

double RayLines::least_finest(const TileRays& rays, double cols, double rows, double s) const {
    if (!std::ranges::all_of(certifies_, [](bool yes) { return yes; })) return 0.0;
    // Norms of directions are largest at a corner.
    double length = 0.0;
    double size = 0.0;
    for (const double col : {0.0, cols - 1}) {
        for (const double row : {0.0, rows - 1}) {
            const glm::dvec3 along = rays.axes().forward + rays.u(col) * rays.axes().right +
                                     rays.v(row) * rays.axes().up;
            length = std::max(length, glm::length(along));
            size = std::max({size, std::abs(along.x), std::abs(along.y), std::abs(along.z)});
        }
    }
    const double cell = std::ranges::min(cell_) / size;
    if (epsilon_ > 0.0) return std::max(cell, epsilon_ / length);
    if (!grows_) return cell;
    return std::max(cell, std::min((look_distance_ + s) * growth_, most_growth_ * cell));
}

bool RayLines::take(const Tile& tile, const TileRays& rays, int col, int row) {
    const double u = rays.u(col);
    const double v = rays.v(row);
    const DepthRange inside = rays.depths(u, v, 0.0, 0.0);
    if (inside.empty()) return false;
    const auto pixel = static_cast<std::uint32_t>(row * tile_size + col);
    RayLine& line = lines_[pixel];
    line.inside = inside;
    double size = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<int>(k);
        const double across = u * rays.axes().right[axis] + v * rays.axes().up[axis];
        line.origin[k] = rays.base()[axis] + rays.distance() * across;
        line.direction[k] = rays.axes().forward[axis] + across;
        if (std::abs(line.direction[k]) <= size) continue;
        size = std::abs(line.direction[k]);
        line.axis = static_cast<std::uint8_t>(k);
    }
    line.per_size = 1.0 / size;
    line.from = inside.enter_lo;
    line.to = inside.exit_hi;
    if (tile.limits != nullptr) {
        const double limit = rays.limit(pixel);
        line.to = std::min(line.to, limit + (1 + extra_slices) * finest(line, limit));
    }
    if (!(line.from <= line.to)) return false;
    pixels_.push_back(pixel);
    return true;
}

void RayLines::begin_singly(const TraceFrame& frame, int digits) {
    lines_.resize(static_cast<std::size_t>(tile_size) * tile_size);
    pixels_.clear();
    set_cells(frame, digits);
}

void RayLines::begin(const TraceFrame& frame, const Tile& tile, const TileRays& rays, int digits) {
    lines_.resize(static_cast<std::size_t>(tile_size) * tile_size);
    pixels_.clear();
    set_cells(frame, digits);
    const double side = 0.5 * tile_size * rays.pixel();  // a little more than to the outermost rays
    const double middle = TileRays::middle_of(tile_size);
    if (rays.depths(rays.u(middle), rays.v(middle), side, side).empty()) return;
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col)
            take(tile, rays, col, row);
    }
}

}  // namespace zeroset
