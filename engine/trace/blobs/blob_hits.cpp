#include "engine/trace/blobs/blob_hits.hpp"

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
    if (sign_ == 0) find_sign(pixel, depth, gradient);
    if (sign_ == 0 || gradient == glm::dvec3(0.0))
        return hits_.push(at, place(pixel, depth), distance, known);
    hits_.any = true;
    hits_.depth[pixel] = distance;
    hits_.certificate[pixel] = known;
    const auto rounded =
        float_gradient({sign_ * gradient.x, sign_ * gradient.y, sign_ * gradient.z});
    for (std::size_t c = 0; c < 3; ++c)
        hits_.gradient[c][pixel] = rounded[c];
}

/// Finds whether f is the blobs less the level, or the level less the blobs.
void BlobHits::find_sign(std::uint32_t pixel, double depth, const glm::dvec3& gradient) {
    const auto at = place(pixel, depth);
    PointBatch<double> point(1);
    point.set(0, at[0], at[1], at[2]);
    point.pad();
    ++counters_.value;
    if (counters_.costs != nullptr) counters_.costs->add(pixel);
    frame_.kernel.in_double.value(point.batch(frame_.scene.uniforms.points<double>()));
    const glm::dvec3 of_f(point.gradient(0, 0), point.gradient(1, 0), point.gradient(2, 0));
    const double along = glm::dot(of_f, gradient);
    sign_ = along > 0 ? 1 : along < 0 ? -1 : 0;
}

void BlobHits::leave(std::uint32_t pixel) {
    hits_.certificate[pixel] = Certificate::Undecided;
    hits_.mark_unsettled(place_of(pixel), 0.0F);
}

}  // namespace zeroset
