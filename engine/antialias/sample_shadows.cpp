#include "engine/antialias/sample_shadows.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

/// So many hits tell.
constexpr int least_hits = 4;
/// Hits whose normals have at least this cosine may be on the same sheet, if they are as far away
/// as it may be so many pixels beside the sample.
constexpr double least_cosine = 0.9;
constexpr double most_pixels = 4.0;
/// The least cosine between ray and normal: sheets seen more from aside are taken as seen so.
constexpr double least_slant = 0.02;

/// How far from a sample along rays its sheet may be in the pixels around it.
double spread_of(const TileRays& rays, const CoverSample& sample, const glm::dvec3& normal) {
    const ViewFrame& view = rays.axes();
    const double u = rays.u(static_cast<double>(sample.col));
    const double v = rays.v(static_cast<double>(sample.row));
    const glm::dvec3 direction = view.forward + u * view.right + v * view.up;
    const double slant = std::abs(glm::dot(direction, normal)) / glm::length(direction);
    // With parallel rays `distance` is so large that its sum with a depth is the same everywhere.
    const double away = view.parallel() ? rays.distance() : static_cast<double>(sample.distance);
    return most_pixels * rays.pixel() * away / std::max(slant, least_slant);
}

}  // namespace

SampleShadow shadow_around(const LitLayer& layer, const Tile& tile, const TileRays& rays,
                           const CoverSample& sample) {
    const glm::dvec3 gradient(sample.gradient[0], sample.gradient[1], sample.gradient[2]);
    const double size = glm::length(gradient);
    if (!(size > 0.0)) return SampleShadow::Unknown;
    const glm::dvec3 normal = gradient / size;
    const double spread = spread_of(rays, sample, normal);
    const int row = sample.pixel / tile_size;
    const int col = sample.pixel % tile_size;
    int lit = 0;
    int dark = 0;
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, tile.rows - 1); ++r) {
        for (int c = std::max(col - 1, 0); c <= std::min(col + 1, tile.cols - 1); ++c) {
            if ((layer.hit_rows[static_cast<std::size_t>(r)] >> c & 1U) == 0) continue;
            const auto at = static_cast<std::size_t>(r * tile_size + c);
            const float apart = layer.hits->depth[at] - sample.distance;
            const glm::dvec3 other = layer.hits->gradient_at(at);
            const bool is_near = static_cast<double>(std::abs(apart)) <= spread;
            if (!is_near || !(glm::dot(other, normal) >= least_cosine * glm::length(other)))
                continue;
            ++(layer.key_light[at] > 0.0F ? lit : dark);
        }
    }
    if (lit + dark < least_hits || (lit > 0 && dark > 0)) return SampleShadow::Unknown;
    return lit > 0 ? SampleShadow::Lit : SampleShadow::Dark;
}

}  // namespace zeroset
