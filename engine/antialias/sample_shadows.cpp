#include "engine/antialias/sample_shadows.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

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

/// The direction of a sample's ray, not of length 1.
glm::dvec3 direction_of(const TileRays& rays, const CoverSample& sample) {
    const ViewFrame& view = rays.axes();
    const double u = rays.u(static_cast<double>(sample.col));
    const double v = rays.v(static_cast<double>(sample.row));
    return view.forward + u * view.right + v * view.up;
}

/// A bit for each pixel of a row that may be one of those around a column.
std::uint64_t bits_around(int col) { return col > 0 ? std::uint64_t{7} << (col - 1) : 3; }

/// The hits that are on a sample's sheet, as far as these tell.
class SheetAround {
public:
    /// `spread`: how far from the sample along rays the sheet may be in the pixels around it.
    SheetAround(const LitLayer& layer, const glm::dvec3& gradient, double spread, float distance)
        : layer_(layer),
          gradient_(gradient),
          least_square_(least_cosine * least_cosine * glm::dot(gradient, gradient)),
          spread_(spread),
          distance_(distance) {}

    [[nodiscard]] bool holds(std::size_t at) const {
        const float apart = layer_.hits->depth[at] - distance_;
        if (!(static_cast<double>(std::abs(apart)) <= spread_)) return false;
        const glm::dvec3 other = layer_.hits->gradient_at(at);
        const double product = glm::dot(other, gradient_);
        return product >= 0.0 && product * product >= least_square_ * glm::dot(other, other);
    }

private:
    const LitLayer& layer_;
    glm::dvec3 gradient_;
    double least_square_, spread_;
    float distance_;
};

}  // namespace

SampleShadow shadow_around(const LitLayer& layer, const Tile& tile, const TileRays& rays,
                           const UnitVector& to_light, const CoverSample& sample) {
    const int row = sample.pixel / tile_size;
    const int first = std::max(row - 1, 0);
    const int last = std::min(row + 1, tile.rows - 1);
    const std::uint64_t around = bits_around(sample.pixel % tile_size);
    int hits = 0;
    for (int r = first; r <= last; ++r)
        hits += std::popcount(layer.hit_rows[static_cast<std::size_t>(r)] & around);
    if (hits < least_hits) return SampleShadow::Unknown;

    const glm::dvec3 gradient(sample.gradient[0], sample.gradient[1], sample.gradient[2]);
    const glm::dvec3 direction = direction_of(rays, sample);
    const double slope = glm::dot(gradient, direction);
    // Rays to the light run against it.
    if (!(slope * glm::dot(gradient, to_light) < 0.0)) return SampleShadow::Unknown;
    const double sizes = std::sqrt(glm::dot(gradient, gradient) * glm::dot(direction, direction));
    // With parallel rays `distance` is so large that its sum with a depth is the same everywhere.
    const double away =
        rays.axes().parallel() ? rays.distance() : static_cast<double>(sample.distance);
    const double spread =
        most_pixels * rays.pixel() * away * sizes / std::max(std::abs(slope), least_slant * sizes);
    const SheetAround sheet(layer, gradient, spread, sample.distance);
    int lit = 0;
    int dark = 0;
    for (int r = first; r <= last; ++r) {
        std::uint64_t bits = layer.hit_rows[static_cast<std::size_t>(r)] & around;
        for (; bits != 0; bits &= bits - 1) {
            const auto at = static_cast<std::size_t>(r * tile_size + std::countr_zero(bits));
            if (!sheet.holds(at)) continue;
            ++(layer.key_light[at] > 0.0F ? lit : dark);
            if (lit > 0 && dark > 0) return SampleShadow::Unknown;
        }
    }
    if (lit + dark < least_hits) return SampleShadow::Unknown;
    return lit > 0 ? SampleShadow::Lit : SampleShadow::Dark;
}

}  // namespace zeroset
