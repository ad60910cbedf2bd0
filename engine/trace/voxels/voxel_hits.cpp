#include "engine/trace/voxels/voxel_hits.hpp"

#include <glm/glm.hpp>

#include <cstddef>

namespace zeroset {

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
    if (gradients_.put(pixel, hits_.points.back().position, gradient)) hits_.points.pop_back();
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
