#include "engine/antialias/cover_light.hpp"

#include "engine/image/background.hpp"
#include "engine/image/gamma.hpp"
#include "engine/light/shade.hpp"
#include "engine/light/shadow.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>

namespace zeroset {
namespace {

constexpr std::size_t slots = std::size_t{tile_size} * tile_size;

/// Every other bit of a number below 64, from the lowest on.
constexpr std::size_t even_bits(std::size_t k) {
    return (k & 1U) | (k >> 1U & 2U) | (k >> 2U & 4U);
}

/// The pixel of sample k in a tile made of samples: one after the other in squares of 8 x 8, and
/// there in quarters of quarters, as those that follow each other are near each other.
constexpr std::size_t slot_of(std::size_t k) {
    const std::size_t square = k / 64;
    const std::size_t row = square / 8 * 8 + even_bits(k % 64 >> 1U);
    const std::size_t col = square % 8 * 8 + even_bits(k % 64);
    return row * tile_size + col;
}

/// A number that is near for samples that are near each other: of squares of 8 x 8 pixels the
/// samples follow each other by surface, and then by distance.
std::uint64_t nearness(const CoverSample& sample) {
    const std::size_t row = sample.pixel / tile_size / 8;
    const std::size_t col = sample.pixel % tile_size / 8;
    const std::uint64_t square = row * 8 + (row % 2 == 0 ? col : 7 - col);
    return (square << 8U | sample.surface) << 32U |
           std::bit_cast<std::uint32_t>(std::max(sample.distance, 0.0F));
}

/// Whether samples are lit sooner where those that are near each other follow each other.
bool gains_by_nearness(const FrameLight& light, std::span<const TraceFrame> surfaces) {
    if (!light.settings().shadows) return false;
    return !light.takes_known_shadows() || std::ranges::any_of(surfaces, gains_by_squares);
}

}  // namespace

void CoverLight::put(const CoverSample& sample, std::size_t slot) {
    cols_[slot] = sample.col;
    rows_[slot] = sample.row;
    surface_of_slot_[slot] = sample.surface;
    TileHits& hits = hits_[sample.surface];
    hits.any = true;
    hits.depth[slot] = sample.distance;
    hits.certificate[slot] = sample.certificate;
    for (std::size_t axis = 0; axis < 3; ++axis)
        hits.gradient[axis][slot] = sample.gradient[axis];
}

void CoverLight::take_shadow(SampleShadow shadow, std::size_t slot) {
    if (shadow == SampleShadow::Unknown) return;
    const std::uint64_t bit = std::uint64_t{1} << slot % tile_size;
    known_.known[slot / tile_size] |= bit;
    if (shadow == SampleShadow::Dark) known_.dark[slot / tile_size] |= bit;
}

void CoverLight::take(std::span<const NearSample> some) {
    for (const LitLayer& layer : lit_.layers()) {
        for (std::size_t k = 0; k < some.size(); ++k) {
            const std::size_t slot = slot_of(k);
            if (surface_of_slot_[slot] != layer.surface) continue;
            CoverColor& color = light_[some[k].sample];
            const auto row = static_cast<int>(slot / tile_size);
            for (int channel = 0; channel < 3; ++channel)
                color[static_cast<std::size_t>(channel)] =
                    layer.light_row(row, channel)[slot % tile_size];
            color[3] = layer.cover.empty() ? 1.0F : layer.cover[slot];
        }
    }
}

void CoverLight::forget(std::span<const CoverSample> samples, std::span<const NearSample> some) {
    for (std::size_t k = 0; k < some.size(); ++k) {
        TileHits& hits = hits_[samples[some[k].sample].surface];
        hits.any = false;
        hits.depth[slot_of(k)] = std::numeric_limits<float>::infinity();
    }
}

std::span<const CoverColor> CoverLight::light(const FrameLight& frame_light,
                                              std::span<const TraceFrame> surfaces,
                                              const TimeLimit& limit, const Tile& tile,
                                              std::span<const LitLayer> layers,
                                              std::span<const CoverSample> samples,
                                              Counters& counters) {
    cols_.resize(slots);
    rows_.resize(slots);
    surface_of_slot_.resize(slots);
    hits_.resize(std::max(hits_.size(), surfaces.size()));
    light_.assign(samples.size(), CoverColor{});
    by_nearness_.clear();
    for (std::size_t k = 0; k < samples.size(); ++k)
        by_nearness_.push_back({.nearness = nearness(samples[k]), .sample = k});
    if (gains_by_nearness(frame_light, surfaces))
        std::ranges::sort(by_nearness_, {}, &NearSample::nearness);
    const TileRays rays(surfaces.front(), tile);
    std::vector<const LitLayer*> layer_of(surfaces.size(), nullptr);
    for (const LitLayer& layer : layers) {
        if (frame_light.takes_known_shadows()) layer_of[layer.surface] = &layer;
    }
    const UnitVector to_light = key_light(surfaces.front().view);
    const RayPlaces places{.col = cols_.data(), .row = rows_.data()};
    Tile of_samples{.col = tile.col,
                    .row = tile.row,
                    .cols = tile_size,
                    .rows = tile_size,
                    .limits = nullptr,
                    .places = &places};
    // Light the samples by the tile, each in the place of a pixel.
    for (std::size_t first = 0; first < samples.size() && !limit.over(); first += slots) {
        const std::size_t count = std::min(slots, samples.size() - first);
        for (TileHits& hits : hits_)
            hits.clear();
        const auto some = std::span(by_nearness_).subspan(first, count);
        known_ = {};
        for (std::size_t k = 0; k < count; ++k) {
            const CoverSample& sample = samples[some[k].sample];
            put(sample, slot_of(k));
            const LitLayer* const layer = layer_of[sample.surface];
            if (layer != nullptr)
                take_shadow(shadow_around(*layer, tile, rays, to_light, sample), slot_of(k));
        }
        of_samples.rows = static_cast<int>((count + 511) / 512 * 8);
        const auto hits = std::span(hits_).first(surfaces.size());
        frame_light.light(surfaces, limit, of_samples, hits, lit_, counters, known_);
        take(some);
        forget(samples, some);
    }
    return light_;
}

void draw_cover(const Tile& tile, std::span<const MixedPixel> pixels,
                std::span<const CoverSample> samples, std::span<const CoverColor> light,
                const Canvas& out) {
    struct Sum {
        CoverColor light{};
        float area = 0.0F;
    };
    thread_local std::vector<Sum> sums;
    thread_local std::vector<std::uint16_t> sum_of_pixel(slots);
    // Add up the light of each pixel's samples, by area.
    sums.assign(pixels.size(), Sum());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        sum_of_pixel[pixels[i].pixel] = static_cast<std::uint16_t>(i);
    for (std::size_t k = 0; k < samples.size(); ++k) {
        Sum& sum = sums[sum_of_pixel[samples[k].pixel]];
        sum.area += samples[k].area;
        for (std::size_t channel = 0; channel < 4; ++channel)
            sum.light[channel] += samples[k].area * std::clamp(light[k][channel], 0.0F, 1.0F);
    }
    std::uint64_t rows = 0;
    int background_row = -1;
    std::uint32_t behind = 0;
    CoverColor background_channels{};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const int row = tile.row + pixels[i].pixel / tile_size;
        const int col = tile.col + pixels[i].pixel % tile_size;
        const Sum& sum = sums[i];
        if (row != background_row) {
            background_row = row;
            rows |= std::uint64_t{1} << (row - tile.row);
            behind = background_color(out.pixels.background, row, out.height);
            for (unsigned channel = 0; channel < 3; ++channel)
                background_channels[channel] = light_of_channel(behind >> 8 * channel & 0xFFU);
        }
        // Threads are drawn wider than they are, so that there may be more than a pixel of parts.
        const float area = std::min(sum.area, 1.0F);
        const float scale = sum.area > 1.0F ? 1.0F / sum.area : 1.0F;
        const auto alpha = static_cast<std::uint32_t>(scale * sum.light[3] * 255.0F + 0.5F);
        std::uint32_t color = (alpha == 0 ? 255U : alpha) << 24U;
        const std::size_t to = out.index(col, row);
        for (unsigned channel = 0; channel < 3; ++channel) {
            const float mixed =
                scale * sum.light[channel] + (1.0F - area) * background_channels[channel];
            color |= channel_of_light(mixed) << 8 * channel;
        }
        out.pixels.color[to] = color;
        if (out.pixels.light.empty()) continue;
        const auto background = background_light(out.pixels.background, row, out.height);
        for (std::size_t channel = 0; channel < 3; ++channel)
            out.pixels.light[to][channel] =
                scale * sum.light[channel] + (1.0F - area) * background[channel];
        out.pixels.light[to][3] = scale * sum.light[3];
    }
    if (out.blank_rows != nullptr) *out.blank_rows &= ~rows;
}

}  // namespace zeroset
