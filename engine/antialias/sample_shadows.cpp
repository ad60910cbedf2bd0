#include "engine/antialias/seen_sheet.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset {
namespace {

/// The least number of hits on the sheet that tell a shadow.
constexpr int least_hits = 4;
/// Hits whose normals have at least this cosine may be on the same sheet, if they are not too far
/// from each other.
constexpr double least_normal_cosine = 0.9;

/// A bit for each pixel of a row that may be one of those around a column.
std::uint64_t bits_around(int col) { return col > 0 ? std::uint64_t{7} << (col - 1) : 3; }

/// Whether a hit of the layer is on a sample's sheet.
bool is_on(const SeenSheet& sheet, float distance, const LitLayer& layer, std::size_t at) {
    const float apart = std::abs(layer.hits->depth[at] - distance);
    if (!sheet.may_be_apart(static_cast<double>(apart))) return false;
    const glm::dvec3 other = layer.hits->gradient_at(at);
    const double product = glm::dot(other, sheet.gradient);
    return product >= 0.0 && product * product >= least_normal_cosine * least_normal_cosine *
                                                      glm::dot(other, other) *
                                                      glm::dot(sheet.gradient, sheet.gradient);
}

}  // namespace

SampleShadow shadow_around(const LitLayer& layer, const Tile& tile, const TileRays& rays,
                           const UnitVector& to_light, const CoverSample& sample) {
    const int row = sample.pixel / tile_size;
    const int first = std::max(row - 1, 0);
    const int last = std::min(row + 1, tile.rows - 1);
    const std::uint64_t around = bits_around(sample.pixel % tile_size);
    // Count the hits of the surface around, and the dark ones among them.
    int hits = 0;
    int dark_hits = 0;
    for (auto r = static_cast<std::size_t>(first); r <= static_cast<std::size_t>(last); ++r) {
        hits += std::popcount(layer.hit_rows[r] & around);
        dark_hits += std::popcount(layer.hit_rows[r] & layer.dark_rows[r] & around);
    }
    if (hits < least_hits) return SampleShadow::Unknown;
    // Where all are alike, so are those on the sheet: the first few tell.
    const bool alike = dark_hits == 0 || dark_hits == hits;
    const int enough = alike ? least_hits : hits;

    const SeenSheet sheet(rays, static_cast<double>(sample.col), static_cast<double>(sample.row),
                          static_cast<double>(sample.distance),
                          {sample.gradient[0], sample.gradient[1], sample.gradient[2]});
    if (!sheet.shows_side_to(to_light)) return SampleShadow::Unknown;
    // Count those on the sample's sheet until they disagree, or enough agree.
    int lit = 0;
    int dark = 0;
    for (int r = first; r <= last && lit + dark < enough; ++r) {
        std::uint64_t bits = layer.hit_rows[static_cast<std::size_t>(r)] & around;
        for (; bits != 0 && lit + dark < enough; bits &= bits - 1) {
            const auto at = static_cast<std::size_t>(r * tile_size + std::countr_zero(bits));
            if (!is_on(sheet, sample.distance, layer, at)) continue;
            const bool is_dark =
                (layer.dark_rows[static_cast<std::size_t>(r)] >> at % tile_size & 1U) != 0;
            ++(is_dark ? dark : lit);
            if (lit > 0 && dark > 0) return SampleShadow::Unknown;
        }
    }
    if (lit + dark < least_hits) return SampleShadow::Unknown;
    return lit > 0 ? SampleShadow::Lit : SampleShadow::Dark;
}

}  // namespace zeroset
