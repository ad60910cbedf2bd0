#include "engine/trace/voxels/ray_block.hpp"

#include <limits>

namespace zeroset {
namespace {

std::array<double, 3> turned(const IndexMap& map, const glm::dvec3& along) {
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            result[i] += map.index_from_world[i][c] * along[static_cast<int>(c)];
    }
    return result;
}

/// More than rounding moves places in a grid.
constexpr double spare_sample = 1e-4;

}  // namespace

IndexRays::IndexRays(const TileRays& rays, const IndexMap& map)
    : base(turned(map, rays.base())),
      right(turned(map, rays.axes().right)),
      up(turned(map, rays.axes().up)),
      forward(turned(map, rays.axes().forward)),
      distance(rays.distance()) {
    for (std::size_t i = 0; i < 3; ++i)
        base[i] += map.shift[i];
}

RayBlock::RayBlock(const IndexRays& rays, double u, double v, double u_radius, double v_radius,
                   double from, double to, const std::array<std::int32_t, 3>& last_cell)
    : last_cell_(last_cell) {
    const IndexRays::Ray middle = rays.ray(u, v);
    // Choose the axis that the middle ray is nearest to.
    const auto size = [&](std::size_t axis) { return std::abs(middle.along[axis]); };
    std::size_t k = size(1) > size(0) ? 1 : 0;
    if (size(2) > size(k)) k = 2;
    axes_ = {.i = k == 0 ? std::size_t{1} : 0, .j = k == 2 ? std::size_t{1} : 2, .k = k};
    step_ = middle.along[k] > 0 ? 1 : -1;
    if (!std::isfinite(from) || !std::isfinite(to)) return;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    // Find the lines of the four corner rays, which bound the bundle.
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const IndexRays::Ray ray = rays.ray(u + ((corner & 1U) != 0 ? u_radius : -u_radius),
                                            v + ((corner & 2U) != 0 ? v_radius : -v_radius));
        const double along = ray.along[k];
        if (!(along * step_ > 0.25 * size(k))) return;
        const auto line = [&](std::size_t axis) {
            const double slope = ray.along[axis] / along;
            return Line{.at = ray.at[axis] - slope * ray.at[k], .slope = slope};
        };
        corners_[corner] = {.i = line(axes_.i),
                            .j = line(axes_.j),
                            .depth = {.at = -ray.at[k] / along, .slope = 1 / along}};
        for (const double depth : {from, to}) {
            const double place = ray.at[k] + depth * along;
            lowest = std::min(lowest, place);
            highest = std::max(highest, place);
        }
    }
    usable_ = true;
    last_layer_ = first_layer_ - step_;  // none
    // Find the layers of the grid that the rays are in.
    const double last = last_cell[k];
    if (highest < -spare_sample || lowest > last + 1 + spare_sample) return;
    const auto layer = [&](double place) {
        return static_cast<std::int32_t>(std::clamp(std::floor(place), 0.0, last));
    };
    const std::int32_t low = layer(lowest - spare_sample);
    const std::int32_t high = layer(highest + spare_sample);
    first_layer_ = step_ > 0 ? low : high;
    last_layer_ = step_ > 0 ? high : low;
}

CellRectangle RayBlock::cells(std::int32_t low, std::int32_t high) const {
    const double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 4> ends{infinity, -infinity, infinity, -infinity};
    for (const Corner& corner : corners_) {
        for (const double k : {static_cast<double>(low), high + 1.0}) {
            ends[0] = std::min(ends[0], corner.i(k));
            ends[1] = std::max(ends[1], corner.i(k));
            ends[2] = std::min(ends[2], corner.j(k));
            ends[3] = std::max(ends[3], corner.j(k));
        }
    }
    // Within the grid, or beside it so that the rectangle is empty
    const auto cell = [](double place, std::int32_t least, std::int32_t most) {
        return static_cast<std::int32_t>(
            std::clamp(std::floor(place), static_cast<double>(least), static_cast<double>(most)));
    };
    const std::int32_t i_last = last_cell_[axes_.i];
    const std::int32_t j_last = last_cell_[axes_.j];
    return {.i_first = cell(ends[0] - spare_sample, 0, i_last + 1),
            .i_last = cell(ends[1] + spare_sample, -1, i_last),
            .j_first = cell(ends[2] - spare_sample, 0, j_last + 1),
            .j_last = cell(ends[3] + spare_sample, -1, j_last)};
}

double RayBlock::depth_at(std::int32_t layer) const {
    const double k = step_ > 0 ? layer : layer + 1.0;
    double least = std::numeric_limits<double>::infinity();
    for (const Corner& corner : corners_)
        least = std::min(least, corner.depth(k));
    return least;
}

}  // namespace zeroset
