#include "engine/trace/blobs/blob_hits.hpp"

#include <glm/glm.hpp>

#include <cstddef>

namespace zeroset {

std::array<double, 3> BlobHits::place(std::uint32_t pixel, double depth) const {
    const TileHits::Pixel at = place_of(pixel);
    const glm::dvec3 point = rays_.point(at.col, at.row, depth);
    return {point.x, point.y, point.z};
}

void BlobHits::tell(std::uint32_t pixel, double depth, bool proved,
                    const std::array<double, 3>& slope) {
    const TileHits::Pixel at = place_of(pixel);
    const auto distance =
        static_cast<float>(rays_.distance_at(depth, rays_.u(at.col), rays_.v(at.row)));
    const Certificate known = proved ? Certificate::Certified : Certificate::Undecided;
    const ViewFrame& view = rays_.axes();
    const glm::dvec3 gradient =
        slope[0] * view.right + slope[1] * view.up + slope[2] * view.forward;
    const std::array<double, 3> position = place(pixel, depth);
    if (!gradients_.put(pixel, position, gradient))
        return hits_.push(at, position, distance, known);
    hits_.any = true;
    hits_.depth[pixel] = distance;
    hits_.certificate[pixel] = known;
}

void BlobHits::leave(std::uint32_t pixel) {
    hits_.certificate[pixel] = Certificate::Undecided;
    hits_.mark_unsettled(place_of(pixel), 0.0F);
}

}  // namespace zeroset
