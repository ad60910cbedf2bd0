#include "engine/light/shadow.hpp"

#include "engine/light/light_places.hpp"
#include "engine/light/shadow_search.hpp"
#include "engine/trace/frame_union.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/ways/surface_ways.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
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
        return hits.gradient_at(at);
    }
    return glm::dvec3(0.0);
}

/// The light as an eye with parallel rays that sees the whole clip box. It is upright where the
/// surface is steepest in its view: hits of a surface that it sees from aside lie in a thin box.
ViewFrame light_view(const TraceFrame& frame, const UnitVector& to_light,
                     const glm::dvec3& gradient) {
    const glm::dvec3 steepest = gradient - glm::dot(gradient, to_light) * to_light;
    const double size = glm::length(steepest);
    const bool is_known = std::isfinite(size) && size > 1e-3 * glm::length(gradient);
    const ViewFrame& eye = frame.view;
    const Box& clip = frame.scene.clip;
    const glm::dvec3 look_at = eye.look_at();
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
    TraceFrame seen = frame;
    seen.view = light;
    seen.image = {.width = tile_size, .height = tile_size};
    seen.limit = limit;
    seen.whole_pixels = false;
    return seen;
}

constexpr Square whole_tile{.col = 0, .row = 0, .side = tile_size};

constexpr Tile light_tile{.col = 0, .row = 0, .cols = tile_size, .rows = tile_size};

/// Takes the hits on caps out of those of a layer.
TileBits without_caps(const LitLayer& layer, TileBits hits) {
    if (!layer.hits->any_cap) return hits;
    for (std::size_t at = 0; at < layer.hits->cap.size(); ++at) {
        if (layer.hits->is_cap(at)) hits[at / tile_size] &= ~(std::uint64_t{1} << at % tile_size);
    }
    return hits;
}

TileBits inside(const TileBits& bits, const Square& square) {
    TileBits part{};
    for (std::size_t row = square.row; row < std::size_t{square.row} + square.side; ++row)
        part[row] = bits[row] & square.bits();
    return part;
}

TileBits both(TileBits a, const TileBits& b) {
    for (std::size_t row = 0; row < tile_size; ++row)
        a[row] &= b[row];
    return a;
}

TileBits without(TileBits a, const TileBits& b) {
    for (std::size_t row = 0; row < tile_size; ++row)
        a[row] &= ~b[row];
    return a;
}

TileBits proved_dark(const ShadowBits& found) { return without(found.dark, found.unproved); }

bool any(const TileBits& bits) {
    return std::ranges::any_of(bits, [](std::uint64_t row) { return row != 0; });
}

std::uint64_t count(const TileBits& bits) {
    std::uint64_t sum = 0;
    for (const std::uint64_t row : bits)
        sum += static_cast<std::uint64_t>(std::popcount(row));
    return sum;
}

/// Searches the hits of `search`, which are all in a square of the tile: with a kernel of their own
/// where it pays, and those of each quarter of the square with one made of that while it is long.
void search_square(const ShadowSearch& search, const Square& square, ShadowBits& found,
                   Counters& counters) {
    constexpr std::size_t long_steps = 48;
    constexpr int least_side = 8;  // those of fewer hits fill no batch
    if (!any(search.open) || search.light.stopped()) return;
    const auto own = kernel_before_hits(search, square);
    const TraceFrame light =
        search.light.with(own ? *own : search.light.kernel, search.light.limit);
    if (own != nullptr && own->steps > long_steps && square.side > least_side) {
        for (const Square& quarter : square.quarters())
            search_square(search.with(light, inside(search.open, quarter)), quarter, found,
                          counters);
        return;
    }
    const ShadowSearch part = search.with(light, search.open);
    std::vector<LightRay> rest;
    search_beams(part, found, rest, counters);
    search_rays(part, rest, found, counters);
}

LightBox in_view(const Box& box, const ViewFrame& light, double spare) {
    const glm::dvec3 middle = 0.5 * (box.lo + box.hi) - light.look_at();
    const glm::dvec3 half = 0.5 * (box.hi - box.lo);
    LightBox seen{};
    const auto set = [&](double(&ends)[2], const glm::dvec3& axis) {
        const double at = glm::dot(middle, axis);
        const double radius = glm::dot(half, glm::abs(axis)) + spare;
        ends[0] = at - radius;
        ends[1] = at + radius;
    };
    set(seen.u, light.right);
    set(seen.v, light.up);
    set(seen.s, light.forward);
    return seen;
}

/// A member of a union, where it may be in the light's view.
struct LitMember {
    const Kernel* kernel;
    LightBox box;
};

/// The members of the surface as a union; none where it is not known as one, or where they cannot
/// be searched one by one.
std::vector<LitMember> members_of(const TraceFrame& light) {
    std::vector<LitMember> found;
    const Scene& scene = light.scene;
    const Specializer* const specializer = light.kernel.specializer.get();
    const UnionParts* const members = specializer == nullptr ? nullptr : specializer->union_parts();
    if (members == nullptr || !scene.region.is_whole()) return found;
    const auto reaches = members->reaches(reach_box(scene.clip), scene.uniforms);
    const double spare = 4 * place_error(light);
    for (std::size_t i = 0; i < reaches->size(); ++i) {
        const Reach& reach = (*reaches)[i];
        if (!reach.any) continue;
        if (!reach.continuous) return {};
        found.push_back({.kernel = members->kernels()[i],
                         .box = in_view(box_of(reach.box), light.view, spare)});
    }
    return found;
}

/// Hits at which no member of the union is below 0: those on it that are seen from outside, and
/// those beside all members.
TileBits outside_hits(const ShadowSearch& search, const std::vector<LitMember>& members) {
    TileBits outside = both(search.open, both(search.roots, search.places.outside));
    TileBits others = without(search.open, search.roots);
    for (const LitMember& member : members)
        others = without(others, places_in(search.places, others, member.box));
    for (std::size_t row = 0; row < tile_size; ++row)
        outside[row] |= others[row];
    return outside;
}

/// Searches the members one by one, each for the hits before which it may lie: a ray from outside a
/// union meets it where it first meets any of them.
void search_members(const ShadowSearch& search, const std::vector<LitMember>& members,
                    ShadowBits& found, Counters& counters) {
    for (const LitMember& member : members) {
        LightBox shadow = member.box;
        shadow.s[1] = std::numeric_limits<double>::infinity();
        const TileBits open =
            without(places_in(search.places, search.open, shadow), proved_dark(found));
        const TraceFrame light = search.light.with(*member.kernel, search.light.limit);
        ShadowSearch of_member = search.with(light, open);
        of_member.is_member = true;
        search_square(of_member, whole_tile, found, counters);
    }
}

/// Adds to `found` the hits among `open` that lie in the shadow of a surface.
void search_surface(const TraceFrame& frame, const TraceFrame& light, const LightPlaces& places,
                    const TileBits& open, const TileBits& roots, bool singly, ShadowBits& found,
                    Counters& counters) {
    const TileRays rays(light, light_tile);
    const LightWalls walls(rays);
    const double cell = frame.scene.clip.size() * std::ldexp(1.0, -frame.depth.wanted);
    const double extent = std::min(frame.scene.clip.size(), frame.view.look_distance);
    ShadowSearch search{.light = light,
                        .rays = rays,
                        .walls = walls,
                        .places = places,
                        .open = open,
                        .roots = roots,
                        .is_member = false,
                        .finest = std::max(0x1p-14 * extent, 4 * cell),  // Knoll's d_stop - 2
                        .bias = std::max(0x1p-12 * extent, 6 * cell),
                        .singly = singly};
    if (find_followed_shadows(search, found, counters)) return;
    const std::vector<LitMember> members = members_of(light);
    if (!members.empty()) {
        search.open = outside_hits(search, members);
        search_members(search, members, found, counters);
        search.open = without(open, search.open);
    }
    search_square(search, whole_tile, found, counters);
}

}  // namespace

ShadowBits find_shadows(std::span<const TraceFrame> surfaces, const UnitVector& to_light,
                        const TimeLimit& limit, const Tile& tile, std::span<const LitLayer> layers,
                        Counters& counters, const TileBits& left_out) {
    ShadowBits found;
    if (layers.empty()) return found;
    thread_local const auto kept = std::make_unique<LightPlaces>();
    LightPlaces& places = *kept;
    thread_local std::vector<TileBits> turned;  // to the light, of each layer
    places.error = 0.0;
    places.outside = {};
    turned.clear();
    TileBits open{};
    const ViewFrame light =
        light_view(surfaces.front(), to_light, gradient_of(*layers.front().hits));
    for (const LitLayer& layer : layers) {
        turned.push_back(find_places(surfaces.front(), light, tile, *layer.hits, places));
        for (std::size_t row = 0; row < tile_size; ++row)
            open[row] |= turned.back()[row] & ~left_out[row];
    }
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        TileBits roots{};
        for (std::size_t k = 0; k < layers.size(); ++k) {
            if (layers[k].surface == i) roots = without_caps(layers[k], turned[k]);
        }
        search_surface(surfaces[i], light_frame(surfaces[i], light, limit), places, open, roots,
                       tile.places != nullptr, found, counters);
        open = without(open, proved_dark(found));
    }
    if (tile.places == nullptr) counters.unproved_shadows += count(found.unproved);
    return found;
}

bool gains_by_squares(const TraceFrame& surface) {
    const SurfaceWay& way = way_of(surface.kernel);
    return surface.kernel.specializer != nullptr || (way.is_level_set() && way.follows(surface));
}

void darken(const TileBits& dark, std::span<LitLayer> layers) {
    for (LitLayer& layer : layers) {
        for (std::size_t row = 0; row < tile_size; ++row) {
            for (std::uint64_t bits = dark[row]; bits != 0; bits &= bits - 1) {
                const auto col = static_cast<std::size_t>(std::countr_zero(bits));
                if (!(layer.hits->depth[row * tile_size + col] <
                      std::numeric_limits<float>::infinity()))
                    continue;
                layer.dark_rows[row] |= bits & (~bits + 1);
            }
        }
    }
}

}  // namespace zeroset
