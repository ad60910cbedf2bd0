#include "engine/light/shadow.hpp"

#include "engine/light/light_places.hpp"
#include "engine/light/shade.hpp"
#include "engine/light/shadow_search.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace zeroset {
namespace {

/// A gradient in the middle of a tile's hits, or near it; 0: there is none.
glm::dvec3 gradient_of(const TileHits& hits) {
    constexpr std::size_t step = 7 * tile_size + 7;  // passes all columns and rows
    constexpr std::size_t pixels = std::size_t{tile_size} * tile_size;
    for (std::size_t i = 0; i < 64; ++i) {
        const std::size_t at = (pixels / 2 + tile_size / 2 + i * step) % pixels;
        if (!(hits.depth[at] < std::numeric_limits<float>::infinity())) continue;
        return {hits.gradient[0][at], hits.gradient[1][at], hits.gradient[2][at]};
    }
    return glm::dvec3(0.0);
}

/// The light as an eye with parallel rays that sees the whole clip box. It is upright where the
/// surface is steepest in its view: hits of a surface that it sees from aside lie in a thin box.
ViewFrame light_view(const TraceFrame& frame, const glm::dvec3& gradient) {
    const UnitVector to_light = key_light(frame.view);
    const glm::dvec3 steepest = gradient - glm::dot(gradient, to_light) * to_light;
    const double size = glm::length(steepest);
    const bool is_known = std::isfinite(size) && size > 1e-3 * glm::length(gradient);
    const ViewFrame& eye = frame.view;
    const Box& clip = frame.scene.clip;
    const glm::dvec3 look_at = eye.eye + eye.look_distance * eye.forward;
    const double radius =
        glm::length(glm::max(glm::abs(clip.lo - look_at), glm::abs(clip.hi - look_at)));
    constexpr double distance = 2.0;  // in radii; any will do
    return ViewFrame({.eye = look_at + distance * radius * to_light,
                      .look_at = look_at,
                      .up = is_known ? steepest / size : eye.up,
                      .fov_rad = 2.0 * std::atan(1.01 / distance),
                      .projection = Projection::Orthographic});
}

/// A surface in the light's view: one tile, whose pixels do not matter.
TraceFrame light_frame(const TraceFrame& frame, const ViewFrame& light, const TimeLimit& limit) {
    return {.scene = frame.scene,
            .kernel = frame.kernel,
            .view = light,
            .image = {.width = tile_size, .height = tile_size},
            .stop = frame.stop,
            .depth = frame.depth,
            .precision = frame.precision,
            .limit = limit};
}

constexpr Tile light_tile{.col = 0, .row = 0, .cols = tile_size, .rows = tile_size};

/// Takes the hits on caps out of those of a layer.
TileBits without_caps(const LitLayer& layer, TileBits hits) {
    if (!layer.hits->any_cap) return hits;
    for (std::size_t at = 0; at < layer.hits->cap.size(); ++at) {
        if (layer.hits->cap[at] != 0) hits[at / tile_size] &= ~(std::uint64_t{1} << at % tile_size);
    }
    return hits;
}

/// Adds to `found` the hits among `open` that lie in the shadow of a surface.
void search_surface(const TraceFrame& frame, const TraceFrame& light, const LightPlaces& places,
                    const TileBits& open, const TileBits& roots, ShadowBits& found,
                    Counters& counters) {
    thread_local std::vector<LightRay> rest;
    rest.clear();
    const TileRays rays(light, light_tile);
    const double cell = frame.scene.clip.size() * std::ldexp(1.0, -frame.depth.wanted);
    const double extent = std::min(frame.scene.clip.size(), frame.view.look_distance);
    const ShadowSearch search{.light = light,
                              .rays = rays,
                              .places = places,
                              .open = open,
                              .roots = roots,
                              .finest = std::max(0x1p-14 * extent, 4 * cell),  // Knoll's d_stop - 2
                              .bias = std::max(0x1p-12 * extent, 6 * cell)};
    search_beams(search, found, rest, counters);
    search_rays(search, rest, found, counters);
}

void darken(const TileBits& dark, LitLayer& layer) {
    for (std::size_t row = 0; row < tile_size; ++row) {
        for (std::uint64_t bits = dark[row]; bits != 0; bits &= bits - 1) {
            const auto col = static_cast<std::size_t>(std::countr_zero(bits));
            layer.key_light[row * tile_size + col] = 0.0F;
            layer.any_dark = true;
        }
    }
}

TileBits both(TileBits a, const TileBits& b) {
    for (std::size_t row = 0; row < tile_size; ++row)
        a[row] &= b[row];
    return a;
}

}  // namespace

ShadowBits find_shadows(std::span<const TraceFrame> surfaces, const TimeLimit& limit,
                        const Tile& tile, std::span<LitLayer> layers, Counters& counters) {
    ShadowBits found;
    if (layers.empty()) return found;
    thread_local LightPlaces places;
    thread_local std::vector<TileBits> turned;  // to the light, of each layer
    places.error = 0.0;
    turned.clear();
    TileBits open{};
    const ViewFrame light = light_view(surfaces.front(), gradient_of(*layers.front().hits));
    for (const LitLayer& layer : layers) {
        turned.push_back(find_places(surfaces.front(), light, tile, *layer.hits, places));
        for (std::size_t row = 0; row < tile_size; ++row)
            open[row] |= turned.back()[row];
    }
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        TileBits roots{};
        for (std::size_t k = 0; k < layers.size(); ++k) {
            if (layers[k].surface == i) roots = without_caps(layers[k], turned[k]);
        }
        search_surface(surfaces[i], light_frame(surfaces[i], light, limit), places, open, roots,
                       found, counters);
        for (std::size_t row = 0; row < tile_size; ++row)
            open[row] &= ~found.dark[row];
    }
    for (std::size_t k = 0; k < layers.size(); ++k)
        darken(both(found.dark, turned[k]), layers[k]);
    return found;
}

}  // namespace zeroset
