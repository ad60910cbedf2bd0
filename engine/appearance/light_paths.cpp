#include "engine/appearance/light_paths.hpp"

#include "engine/appearance/frame_light.hpp"
#include "engine/appearance/material.hpp"
#include "engine/appearance/path_hits.hpp"
#include "engine/appearance/soft_light.hpp"
#include "engine/image/background.hpp"
#include "engine/image/gamma.hpp"
#include "engine/light/shade.hpp"
#include "engine/light/shadow.hpp"
#include "engine/light/surface_values.hpp"
#include "engine/rays/first_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {
namespace {

/// Linear light as a picture shows it. Filmic: the curve of [Narkowicz15], as bright at 0.18 as
/// plain.
glm::vec3 toned(Tone tone, const glm::vec3& light) {
    if (tone == Tone::Plain) return light;
    constexpr float exposure = 0.7232F;  // toned(0.18) = 0.18
    const glm::vec3 x = exposure * light;
    return glm::clamp(x * (2.51F * x + 0.03F) / (x * (2.43F * x + 0.59F) + 0.14F), 0.0F, 1.0F);
}

constexpr std::size_t pixels = std::size_t{tile_size} * tile_size;
/// Rays of less weight than this are given up: below a step of 8 bits.
constexpr float least_weight = 1.0F / 512.0F;
/// Directions over a hit are closed by what is nearer than this part of the clip box's edge.
constexpr double sky_reach = 0.2;

/// Rays to soft light from a part of a pixel: the noise of whole pixels makes most of those that
/// show it be divided in 16 parts.
constexpr std::size_t rays_a_part = 4;

float greatest(const glm::vec3& v) { return std::max({v.x, v.y, v.z}); }

class PathLight {
public:
    PathLight(const FrameLight& light, std::span<const TraceFrame> surfaces, const TimeLimit& limit,
              const Tile& tile, Counters& counters)
        : light_(light),
          shader_(light.shader()),
          scene_(surfaces.front().scene),
          limit_(limit),
          tile_(tile),
          counters_(counters),
          surfaces_(surfaces.begin(), surfaces.end()),
          sums_(pixels, glm::vec3(0.0F)),
          through_(pixels, glm::vec3(0.0F)) {
        for (TraceFrame& surface : surfaces_)
            surface.limit = limit;
    }

    void run(std::span<LitLayer> layers);

private:
    using LitParts = std::array<float, max_lights>;

    /// Whether rays go on from a surface's hits.
    [[nodiscard]] bool rays_go_on(std::size_t surface) const {
        const bool is_soft = light_.settings().soft_light && has_soft_light(scene_, surface);
        return is_soft || light_.settings().reflections > 0 || light_.opacity(surface) < 1.0F;
    }
    void find_first_shadows(std::span<const LitLayer> layers);
    /// Lights the hits, and lists the rays that go on from them.
    void shade(std::span<const PathHit> hits);
    [[nodiscard]] std::vector<glm::vec3> colors_of(std::span<const PathHit> hits);
    /// How much of each light reaches the hits.
    [[nodiscard]] std::vector<LitParts> lit_parts(std::span<const PathHit> hits);
    void ask_shadows(std::span<const PathHit> hits, std::size_t light, std::span<LitParts> parts);
    [[nodiscard]] std::vector<float> openness(std::span<const PathHit> hits);
    [[nodiscard]] SoftHit soft_hit(const PathHit& hit) const;
    void add_mirrored(const PathHit& hit, const glm::vec3& weight);
    void add_straight(const PathHit& hit, const glm::vec3& weight);
    /// Follows the rays away, or to what they hit: `hits`.
    void follow(std::vector<PathHit>& hits);
    /// The part of the light that solids leave on a way of this length.
    [[nodiscard]] glm::vec3 left_by_solids(std::uint64_t inside, double length) const;
    void write(std::span<LitLayer> layers) const;
    [[nodiscard]] glm::vec3 background(std::size_t pixel) const;

    const FrameLight& light_;
    const HitShader& shader_;
    const Scene& scene_;
    const TimeLimit& limit_;
    const Tile& tile_;
    Counters& counters_;
    std::vector<TraceFrame> surfaces_;
    std::vector<glm::vec3> sums_;              ///< light of pixels so far
    std::vector<glm::vec3> through_;           ///< the part of the background that is seen in them
    std::vector<PathRay> rays_;                ///< to be followed
    std::array<TileBits, max_lights> dark_{};  ///< first hits that a light does not reach
};

void PathLight::find_first_shadows(std::span<const LitLayer> layers) {
    if (!light_.settings().shadows) return;
    for (std::size_t i = 0; i < shader_.lights().size(); ++i) {
        const SeenLight& light = shader_.lights()[i];
        const bool is_soft = light.radius_rad > 0.0 && light_.settings().soft_light;
        if (!light.casts_shadows || is_soft) continue;
        dark_[i] =
            find_shadows(surfaces_, UnitVector(light.towards), limit_, tile_, layers, counters_)
                .dark;
    }
}

std::vector<glm::vec3> PathLight::colors_of(std::span<const PathHit> hits) {
    std::vector<glm::vec3> colors(hits.size());
    std::vector<ColoredHit> colored;
    std::vector<std::size_t> places;
    for (std::size_t number = 0; number < surfaces_.size(); ++number) {
        colored.clear();
        places.clear();
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const PathHit& hit = hits[i];
            if (hit.hit.surface != number) continue;
            const glm::dvec3 along = hit.path.ray.direction;
            places.push_back(i);
            colored.push_back({.point = {.at = hit.point(), .distance = hit.distance()},
                               .gradient = hit.hit.gradient,
                               .is_cap = hit.is_cap,
                               .is_front = !(glm::dot(hit.hit.gradient, along) > 0.0)});
        }
        if (colored.empty()) continue;
        if (has_formula(scene_.coloring.by)) counters_.value += colored.size();
        const std::vector<Reflectance> found = hit_colors(scene_, number, colored);
        for (std::size_t k = 0; k < places.size(); ++k)
            colors[places[k]] = {found[k][0], found[k][1], found[k][2]};
    }
    return colors;
}

SoftHit PathLight::soft_hit(const PathHit& hit) const {
    const glm::dvec3 normal = hit.normal();
    const double cosine = std::abs(glm::dot(normal, glm::dvec3(hit.path.ray.direction)));
    const auto row = static_cast<std::uint32_t>(hit.path.pixel / tile_size);
    const auto col = static_cast<std::uint32_t>(hit.path.pixel % tile_size);
    const std::uint8_t own = hit.is_cap ? no_surface : hit.hit.surface;
    return {.ray = {.origin = hit.point(), .direction = UnitVector(normal), .own = own},
            .normal = normal,
            .error = cosine * hit.hit.error,
            .seed = (static_cast<std::uint32_t>(tile_.row) + row) * 65536U +
                    static_cast<std::uint32_t>(tile_.col) + col,
            .rays = tile_.places == nullptr ? SoftHit::most_rays : rays_a_part,
            .gradient = hit.hit.gradient};
}

void PathLight::ask_shadows(std::span<const PathHit> hits, std::size_t light,
                            std::span<LitParts> parts) {
    const SeenLight& of = shader_.lights()[light];
    // Only hits that the eye sees itself have soft shadows. All hits are first ones or none is.
    const bool is_soft = of.radius_rad > 0.0 && light_.settings().soft_light && hits[0].is_first;
    std::vector<std::size_t> places;
    std::vector<SoftHit> asked;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].is_first && !is_soft) {
            const std::size_t pixel = hits[i].path.pixel;
            const bool is_dark = (dark_[light][pixel / tile_size] >> pixel % tile_size & 1U) != 0;
            parts[i][light] = is_dark ? 0.0F : 1.0F;
        } else {
            const SoftHit hit = soft_hit(hits[i]);
            const double cosine = glm::dot(hit.normal, of.towards);
            if (!(cosine > (is_soft ? -std::sin(of.radius_rad) : 0.0))) continue;
            places.push_back(i);
            asked.push_back(hit);
        }
    }
    if (asked.empty()) return;
    if (is_soft) {
        const std::vector<float> found =
            broad_light(surfaces_, asked, of.towards, of.radius_rad, counters_);
        for (std::size_t k = 0; k < places.size(); ++k)
            parts[places[k]][light] = found[k];
        return;
    }
    std::vector<SceneRay> rays;
    rays.reserve(asked.size());
    for (const SoftHit& hit : asked)
        rays.push_back(leaving(hit, of.towards));
    std::vector<std::uint8_t> blocked(rays.size());
    find_blocked(surfaces_, rays, blocked, counters_);
    for (std::size_t k = 0; k < places.size(); ++k)
        parts[places[k]][light] = blocked[k] != 0 ? 0.0F : 1.0F;
}

auto PathLight::lit_parts(std::span<const PathHit> hits) -> std::vector<LitParts> {
    std::vector<LitParts> parts(hits.size());
    for (LitParts& lit : parts)
        lit.fill(1.0F);
    if (!light_.settings().shadows) return parts;
    for (std::size_t i = 0; i < shader_.lights().size(); ++i) {
        if (shader_.lights()[i].casts_shadows) ask_shadows(hits, i, parts);
    }
    return parts;
}

std::vector<float> PathLight::openness(std::span<const PathHit> hits) {
    std::vector<float> open(hits.size(), 1.0F);
    if (!light_.settings().soft_light) return open;
    std::vector<std::size_t> places;
    std::vector<SoftHit> asked;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const bool matters = ambient_shade(light_.look(hits[i].hit.surface)) > 0.0F;
        if (!hits[i].is_first || !matters) continue;
        places.push_back(i);
        asked.push_back(soft_hit(hits[i]));
    }
    if (asked.empty()) return open;
    const double extent = std::min(scene_.clip.size(), surfaces_.front().view.look_distance);
    const std::vector<float> found = open_sky(surfaces_, asked, sky_reach * extent, counters_);
    for (std::size_t k = 0; k < places.size(); ++k)
        open[places[k]] = found[k];
    return open;
}

void PathLight::add_mirrored(const PathHit& hit, const glm::vec3& weight) {
    if (greatest(weight) < least_weight) return;
    PathRay next = hit.path;
    next.ray = leaving(soft_hit(hit), hit.mirrored());
    next.weight = weight;
    next.before = hit.distance();
    next.roughness = material_of(light_.look(hit.hit.surface)).roughness;
    ++next.mirrors;
    rays_.push_back(next);
}

void PathLight::add_straight(const PathHit& hit, const glm::vec3& weight) {
    if (greatest(weight) < least_weight || hit.path.layers >= max_layers) return;
    PathRay next = hit.path;
    next.ray = leaving(soft_hit(hit), glm::dvec3(hit.path.ray.direction));
    next.weight = weight;
    next.before = hit.distance();
    ++next.layers;
    const std::uint64_t solid = hit.hit.surface < 64 ? std::uint64_t{1} << hit.hit.surface : 0;
    const double slope = glm::dot(hit.hit.gradient, glm::dvec3(hit.path.ray.direction));
    if (scene_.lighting.absorption > 0.0) {
        const bool enters = hit.is_cap || light_.enters_solid(hit.hit.surface, slope);
        next.inside = enters ? next.inside | solid : next.inside & ~solid;
    }
    rays_.push_back(next);
}

void PathLight::shade(std::span<const PathHit> hits) {
    const std::vector<glm::vec3> colors = colors_of(hits);
    const std::vector<LitParts> lit = lit_parts(hits);
    const std::vector<float> open = openness(hits);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const PathHit& hit = hits[i];
        const Look look = light_.look(hit.hit.surface);
        HitLight light = shader_.shade({.look = look,
                                        .towards_eye = -glm::vec3(hit.path.ray.direction),
                                        .normal = glm::vec3(hit.normal()),
                                        .color = colors[i],
                                        .lit = lit[i],
                                        .is_mirrored = hit.path.is_mirrored(),
                                        .open = open[i]});
        if (hit.is_cap) {
            light.body *= cap_tone(surfaces_.front().view, surfaces_.front().image.height,
                                   hit.point(), hit.normal());
            light.gloss = light.mirror = glm::vec3(0.0F);
        }
        const float opacity = light_.opacity(hit.hit.surface);
        const glm::vec3 unmirrored = 1.0F - light.mirror;
        sums_[hit.path.pixel] +=
            hit.path.weight * (opacity * unmirrored * light.body + light.gloss);
        if (opacity < 1.0F) add_straight(hit, hit.path.weight * unmirrored * (1.0F - opacity));
        if (light_.settings().reflections == 0) continue;
        if (hit.path.mirrors < light_.settings().reflections) {
            add_mirrored(hit, hit.path.weight * light.mirror);
        } else {
            sums_[hit.path.pixel] +=
                hit.path.weight * light.mirror *
                shader_.surroundings().seen(glm::vec3(hit.mirrored()), material_of(look).roughness);
        }
    }
}

glm::vec3 PathLight::left_by_solids(std::uint64_t inside, double length) const {
    glm::vec3 left(1.0F);
    for (std::size_t i = 0; inside != 0; ++i, inside >>= 1U) {
        if ((inside & 1U) == 0) continue;
        const SurfaceColors& colors = scene_.colors_of_surface(i);
        const glm::vec3 color(colors.front[0], colors.front[1], colors.front[2]);
        const auto depth = static_cast<float>(scene_.lighting.absorption * length);
        left *= glm::exp(-depth * (1.0F - color));
    }
    return left;
}

glm::vec3 PathLight::background(std::size_t pixel) const {
    const PixelPoint place =
        tile_.place(static_cast<int>(pixel % tile_size), static_cast<int>(pixel / tile_size));
    const std::uint32_t color = background_color(scene_.background, static_cast<int>(place.row),
                                                 surfaces_.front().image.height);
    return {light_of_channel(color & 0xFFU), light_of_channel(color >> 8U & 0xFFU),
            light_of_channel(color >> 16U & 0xFFU)};
}

void PathLight::follow(std::vector<PathHit>& hits) {
    std::vector<SceneRay> rays;
    rays.reserve(rays_.size());
    for (const PathRay& path : rays_)
        rays.push_back(path.ray);
    std::vector<RayHit> found(rays.size());
    find_first_hits(surfaces_, rays, found, counters_);
    hits.clear();
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        PathRay& path = rays_[i];
        if (path.inside != 0) {
            const double length = found[i].is_hit() ? found[i].t : clipped(path.ray, scene_).to;
            if (length > 0.0) path.weight *= left_by_solids(path.inside, length);
        }
        if (found[i].is_hit()) {
            hits.push_back({.path = path, .hit = found[i]});
        } else if (path.is_mirrored()) {
            const glm::vec3 along(path.ray.direction);
            sums_[path.pixel] += path.weight * shader_.surroundings().seen(along, path.roughness);
        } else {
            through_[path.pixel] += path.weight;
        }
    }
    rays_.clear();
}

void PathLight::write(std::span<LitLayer> layers) const {
    for (LitLayer& layer : layers) {
        layer.hit_rows = {};
        layer.cover.resize(pixels);
        for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
            const auto row = static_cast<int>(pixel / tile_size);
            const auto col = pixel % tile_size;
            if (row >= tile_.rows || static_cast<int>(col) >= tile_.cols) continue;
            if (!std::isfinite(layer.hits->depth[pixel])) continue;
            layer.hit_rows[static_cast<std::size_t>(row)] |= std::uint64_t{1} << col;
            glm::vec3 shown = toned(scene_.lighting.tone, sums_[pixel]);
            const glm::vec3& through = through_[pixel];
            if (through != glm::vec3(0.0F)) shown += through * background(pixel);
            layer.cover[pixel] = 1.0F - (through.x + through.y + through.z) / 3.0F;
            for (int channel = 0; channel < 3; ++channel)
                layer.light_row(row, channel)[col] = shown[channel];
        }
    }
}

void PathLight::run(std::span<LitLayer> layers) {
    find_first_shadows(layers);
    // Kept, as asking for so much room anew takes longer than to fill it.
    thread_local std::vector<PathHit> hits;
    hits.clear();
    for (const LitLayer& layer : layers) {
        const TraceFrame& surface = surfaces_[layer.surface];
        const std::size_t first = hits.size();
        add_first_hits(surface, layer.surface, tile_, *layer.hits, hits);
        if (rays_go_on(layer.surface)) sharpen(surface, std::span(hits).subspan(first), counters_);
    }
    while (!hits.empty()) {
        shade(hits);
        if (limit_.over()) break;
        follow(hits);
    }
    write(layers);
}

}  // namespace

void light_paths(const FrameLight& light, std::span<const TraceFrame> surfaces,
                 const TimeLimit& limit, const Tile& tile, std::span<LitLayer> layers,
                 Counters& counters) {
    if (layers.empty()) return;
    PathLight(light, surfaces, limit, tile, counters).run(layers);
}

}  // namespace zeroset
