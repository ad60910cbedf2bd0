#include "engine/trace/voxels/voxel_hits.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/trace/tile_costs.hpp"

#include <glm/glm.hpp>

#include <cstddef>

namespace zeroset {
namespace {

TileHits::Pixel place_of(std::uint32_t pixel) {
    return {.col = static_cast<std::int16_t>(pixel % tile_size),
            .row = static_cast<std::int16_t>(pixel / tile_size)};
}

}  // namespace

void VoxelHits::tell(std::uint32_t pixel, const FirstRoot& root,
                     const std::array<double, 3>& slopes) {
    const RayLine& line = lines_.of(pixel);
    const bool proved = root.is_proved() && root.from() >= line.inside.enter_hi &&
                        root.to() <= line.inside.exit_lo && lines_.certifies(line);
    const TileHits::Pixel at = place_of(pixel);
    const double distance = rays_.distance_at(root.depth(), rays_.u(at.col), rays_.v(at.row));
    hits_.push(at, line.at(root.depth()), static_cast<float>(distance),
               proved ? Certificate::Certified : Certificate::Undecided);
    tell_gradient(pixel, slopes);
}

/// Tells the gradient of the hit that was pushed last, unless it cannot be known here.
void VoxelHits::tell_gradient(std::uint32_t pixel, const std::array<double, 3>& slopes) {
    glm::dvec3 gradient(0.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int c = 0; c < 3; ++c)
            gradient[c] += map_.index_from_world[axis][static_cast<std::size_t>(c)] * slopes[axis];
    }
    if (sign_ == 0) find_sign(gradient);
    if (sign_ == 0 || gradient == glm::dvec3(0.0)) return;
    const auto rounded =
        float_gradient({sign_ * gradient.x, sign_ * gradient.y, sign_ * gradient.z});
    for (std::size_t c = 0; c < 3; ++c)
        hits_.gradient[c][pixel] = rounded[c];
    hits_.points.pop_back();
}

/// Finds whether f is the volume less the level, or the level less the volume, at the hit that was
/// pushed last, where the volume has this gradient.
void VoxelHits::find_sign(const glm::dvec3& gradient) {
    const TileHits::Point& hit = hits_.points.back();
    PointBatch<double> point(1);
    point.set(0, hit.position[0], hit.position[1], hit.position[2]);
    point.pad();
    ++counters_.value;
    if (counters_.costs != nullptr) counters_.costs->add(hit.pixel);
    frame_.kernel.in_double.value(point.batch(frame_.scene.uniforms.points<double>()));
    const glm::dvec3 of_f(point.gradient(0, 0), point.gradient(1, 0), point.gradient(2, 0));
    const double along = glm::dot(of_f, gradient);
    sign_ = along > 0 ? 1 : along < 0 ? -1 : 0;
}

void VoxelHits::leave(int col, int row, int cols, int rows) {
    for (int y = row; y < row + rows; ++y) {
        for (int x = col; x < col + cols; ++x) {
            const TileHits::Pixel at = place_of(static_cast<std::uint32_t>(y * tile_size + x));
            hits_.certificate[at.index()] = Certificate::Undecided;
            hits_.mark_unsettled(at, 0.0F);
        }
    }
}

}  // namespace zeroset
