#include "engine/trace/tile_hits.hpp"

#include "engine/trace/flag_bits.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

constexpr float nowhere = std::numeric_limits<float>::infinity();

constexpr std::size_t pixels = static_cast<std::size_t>(tile_size) * tile_size;

}  // namespace

void PixelCover::clear() {
    if (from.empty()) {
        for (std::vector<float>* const column : {&from, &to, &other_from})
            column->assign(pixels, nowhere);
        last.assign(pixels, -nowhere);
    }
    for_each_block_row(blocks, [this](std::size_t first) {
        for (std::vector<float>* const column : {&from, &to, &other_from})
            std::fill_n(column->data() + first, tile_block, nowhere);
        std::fill_n(last.data() + first, tile_block, -nowhere);
    });
    known = true;
    blocks = 0;
    open_blocks = 0;
}

std::uint64_t PixelCover::mixed_in_row(int row) const {
    const auto first = static_cast<std::size_t>(row) * tile_size;
    constexpr std::uint64_t in_row = (std::uint64_t{1} << (tile_size / tile_block)) - 1;
    std::uint64_t open = open_blocks >> block_of(first) & in_row;
    if (open == 0) return 0;
    std::array<std::uint8_t, tile_size> is_mixed{};
    for (; open != 0; open &= open - 1) {
        const auto block = static_cast<std::size_t>(std::countr_zero(open)) * tile_block;
        for (std::size_t col = block; col < block + tile_block; ++col) {
            const float other = other_from[first + col];
            // Bitwise, so that it is done for many pixels at once.
            const bool some = std::min(from[first + col], other) < nowhere;
            const bool covered = to[first + col] < other;
            is_mixed[col] = static_cast<std::uint8_t>(some && !covered);
        }
    }
    return bits_of_flags(is_mixed);
}

TileHits::TileHits() {
    depth.resize(pixels, nowhere);
    certificate.resize(pixels);
    for (std::vector<float>& axis : gradient)
        axis.resize(pixels);
    unsettled.resize(pixels, nowhere);
    cap.resize(pixels, CapKind::None);
}

void TileHits::clear() {
    if (any) std::ranges::fill(depth, nowhere);
    if (any_unsettled) std::ranges::fill(unsettled, nowhere);
    if (any_cap) std::ranges::fill(cap, CapKind::None);
    any_cap = false;
    any_values = false;
    cover.known = false;
    any = false;
    any_unsettled = false;
    points.clear();
    point_errors.reset();
}

void TileHits::push(Pixel at, const std::array<double, 3>& where, float distance,
                    Certificate known) {
    any = true;
    depth[at.index()] = distance;
    certificate[at.index()] = known;
    points.push_back({.pixel = at.index(), .position = where});
}

void TileHits::mark_unsettled(Pixel at, float distance) {
    any_unsettled = true;
    unsettled[at.index()] = std::min(unsettled[at.index()], distance);
}

void TileHits::leave_undecided(const Tile& tile) {
    std::ranges::fill(certificate, Certificate::Undecided);
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col) {
            const Pixel at{.col = static_cast<std::int16_t>(col),
                           .row = static_cast<std::int16_t>(row)};
            mark_unsettled(at, 0.0F);
        }
    }
}

void TileHits::put_cap(Pixel at, float distance, Certificate known, const glm::dvec3& normal,
                       CapKind kind) {
    const std::size_t pixel = at.index();
    any = true;
    any_cap = true;
    any_values = any_values || kind == CapKind::Values;
    cap[pixel] = kind;
    depth[pixel] = distance;
    certificate[pixel] = known;
    unsettled[pixel] = nowhere;
    for (std::size_t k = 0; k < 3; ++k)
        gradient[k][pixel] = static_cast<float>(normal[static_cast<int>(k)]);
}

std::array<float, 3> float_gradient(const std::array<double, 3>& gradient) {
    constexpr double large = 1e18;
    const double size =
        std::max({std::abs(gradient[0]), std::abs(gradient[1]), std::abs(gradient[2])});
    const bool usual = size <= large && size >= 1.0 / large;
    const double scale = usual || !(size > 0.0) || !std::isfinite(size) ? 1.0 : 1.0 / size;
    return {static_cast<float>(gradient[0] * scale), static_cast<float>(gradient[1] * scale),
            static_cast<float>(gradient[2] * scale)};
}

}  // namespace zeroset
