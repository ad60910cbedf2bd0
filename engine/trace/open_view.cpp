#include "engine/trace/open_view.hpp"

#include "engine/real/unbounded.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// Places in the image where rays surely are that belong to a pixel: half a pixel for those beside
/// its centre, the rest for rounding.
constexpr double pixel_spare = 1.0;

struct Ends {
    double lo, hi;
};

/// Where `[lo, hi] / z` is for z in a range above 0.
Ends over(const Ends& across, const Ends& z) {
    return {.lo = across.lo / (across.lo < 0 ? z.lo : z.hi),
            .hi = across.hi / (across.hi < 0 ? z.hi : z.lo)};
}

std::size_t tiles_across(int pixels) {
    return static_cast<std::size_t>((pixels + tile_size - 1) / tile_size);
}

/// The half of a box's width along an axis of the view.
double half_along(const glm::dvec3& axis, const glm::dvec3& half) {
    return glm::dot(glm::abs(axis), half);
}

}  // namespace

int OpenView::slab_at(double s) const {
    const double place = (s - first_depth_) * slabs_per_depth_;
    return static_cast<int>(std::clamp(place, 0.0, slab_count - 1.0));
}

void OpenView::begin_slabs(const TraceFrame& frame, const Box& box, double spare) {
    const double middle =
        glm::dot(box.centre() - frame.view.eye, frame.view.forward) - frame.view.look_distance;
    const double radius = half_along(frame.view.forward, 0.5 * (box.hi - box.lo)) + spare;
    const double nearest = frame.view.parallel() ? -unbounded : -frame.view.look_distance;
    first_depth_ = std::max(middle - radius, nearest);
    const double length = middle + radius - first_depth_;
    slabs_per_depth_ = length > 0 ? slab_count / length : 0.0;
}

void OpenView::mark(const Seen& seen) {
    const auto tile = [](double place, std::size_t count) {
        return static_cast<std::size_t>(
            std::clamp(place / tile_size, 0.0, static_cast<double>(count) - 1.0));
    };
    if (seen.last_col < 0 || seen.last_row < 0) return;
    const std::size_t first_col = tile(seen.first_col, cols_);
    const std::size_t last_col = tile(seen.last_col, cols_);
    const std::size_t last_row = tile(seen.last_row, rows_);
    const std::uint64_t slabs = slabs_between(seen.from, seen.to);
    for (std::size_t row = tile(seen.first_row, rows_); row <= last_row; ++row) {
        for (std::size_t col = first_col; col <= last_col; ++col)
            slabs_[row * cols_ + col] |= slabs;
    }
}

OpenView::OpenView(const TraceFrame& frame, const OpenSpace& space)
    : cols_(tiles_across(frame.image.width)),
      rows_(tiles_across(frame.image.height)),
      slabs_(cols_ * rows_) {
    const Box& box = space.box;
    const glm::dvec3 size = box.hi - box.lo;
    const glm::dvec3 half = 0.5 / space.side * size;
    // Depths of slabs are rounded to floats, as large as the box seen from the point looked at.
    const glm::dvec3 from_look = glm::abs(box.centre() - frame.view.look_at()) + 0.5 * size;
    const double spare = 4 * place_error(frame) + 0x1p-18 * glm::length(from_look);
    begin_slabs(frame, box, spare);
    const ViewFrame& view = frame.view;
    const double right_half = half_along(view.right, half) + spare;
    const double up_half = half_along(view.up, half) + spare;
    const double along_half = half_along(view.forward, half) + spare;
    const double pixel = view.parallel() ? view.pixel_at_look(frame.image.height)
                                         : view.pixel_size(frame.image.height);
    const auto side = static_cast<std::uint32_t>(space.side);
    for (const std::uint32_t cell : space.cells) {
        const glm::dvec3 at(cell % side, cell / side % side, cell / side / side);
        const glm::dvec3 centre = box.lo + (2.0 * at + 1.0) * half - view.eye;
        const double along = glm::dot(centre, view.forward);
        const Ends z{.lo = along - along_half, .hi = along + along_half};
        const double x = glm::dot(centre, view.right);
        const double y = glm::dot(centre, view.up);
        Ends across{.lo = x - right_half, .hi = x + right_half};
        Ends upwards{.lo = y - up_half, .hi = y + up_half};
        Seen seen{.first_col = 0,
                  .last_col = unbounded,
                  .first_row = 0,
                  .last_row = unbounded,
                  .from = z.lo - view.look_distance,
                  .to = z.hi - view.look_distance};
        if (view.parallel() || z.lo > 0) {
            if (!view.parallel()) {
                across = over(across, z);
                upwards = over(upwards, z);
            }
            const double middle_col = 0.5 * frame.image.width;
            const double middle_row = 0.5 * frame.image.height;
            seen.first_col = middle_col + across.lo / pixel - pixel_spare;
            seen.last_col = middle_col + across.hi / pixel + pixel_spare;
            seen.first_row = middle_row - upwards.hi / pixel - pixel_spare;
            seen.last_row = middle_row - upwards.lo / pixel + pixel_spare;
        } else if (z.hi < 0) {
            continue;
        }
        mark(seen);
    }
}

}  // namespace zeroset
