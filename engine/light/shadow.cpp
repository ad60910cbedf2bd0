#include "engine/light/shadow.hpp"

#include "engine/kernel/form_cells.hpp"
#include "engine/light/shade.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t cells_at_once = 256;

/// A hit on its path to the light: rays of the light, from the back.
struct LightPath {
    LitLayer* layer;
    std::size_t pixel;
    double u, v;                         ///< of the light's ray through the hit
    double from = 0.0, end = 0.0;        ///< depths, from the light
    double to = end;                     ///< not searched yet: from `from` to here
    double step = 0.125 * (end - from);  ///< of the next cell, at `to`

    [[nodiscard]] double next() const { return std::max(from, to - step); }
};

/// The light's distance, in radii of what it lights.
constexpr double light_distance = 16.0;

glm::dvec3 look_point(const ViewFrame& view) {
    return view.eye + view.look_distance * view.forward;
}

/// The radius of a sphere about the point looked at that holds the clip box.
double lit_radius(const ViewFrame& view, const Box& clip) {
    const glm::dvec3 middle = look_point(view);
    return glm::length(glm::max(glm::abs(clip.lo - middle), glm::abs(clip.hi - middle)));
}

/// The light as an eye that sees the whole clip box.
Camera light_camera(const TraceFrame& frame) {
    const double half_height = 1.01 / (light_distance - 1.0);
    return {.eye = shadow_light(frame.view, frame.scene.clip),
            .look_at = look_point(frame.view),
            .up = frame.view.up,
            .fov_rad = 2.0 * std::atan(half_height)};
}

/// The light's view: one tile, whose pixels do not matter.
TraceFrame light_frame(const TraceFrame& frame, const TimeLimit& limit) {
    return {.scene = frame.scene,
            .kernel = frame.kernel,
            .view = ViewFrame(light_camera(frame)),
            .image = {.width = tile_size, .height = tile_size},
            .stop = frame.stop,
            .depth = frame.depth,
            .precision = frame.precision,
            .limit = limit};
}

constexpr Tile light_tile{.col = 0, .row = 0, .cols = tile_size, .rows = tile_size};

/// The search of light paths for the roots of one surface.
template <class Real>
class PathSearch {
public:
    PathSearch(const TraceFrame& light, const TileRays& rays, double finest, Counters& counters)
        : light_(light),
          counters_(counters),
          frustum_(rays.frustum<Real>(1)),
          finest_(finest),
          margin_(rays.depth_error()) {}

    /// Takes away the paths on which there is a root: their hits are in the shadow.
    void search(std::vector<LightPath>& paths);

private:
    enum class Verdict : std::uint8_t { Free, Dark, Open };

    void evaluate(const LightPath* paths, std::size_t count);
    [[nodiscard]] Verdict judge(const LightPath& path, std::size_t i) const;

    const TraceFrame& light_;
    Counters& counters_;
    FrustumOf<Real> frustum_;
    double finest_;  ///< a cell that is no longer and may hold a root throws a shadow
    double margin_;  ///< cells are longer than their part of the path
    FormCells<Real, cells_at_once> cells_;
};

template <class Real>
void PathSearch<Real>::evaluate(const LightPath* paths, std::size_t count) {
    for (std::size_t i = 0; i < padded(count); ++i) {
        const LightPath& path = paths[std::min(i, count - 1)];
        const double next = path.next();
        cells_.u[i] = static_cast<Real>(path.u);
        cells_.v[i] = static_cast<Real>(path.v);
        cells_.s[i] = static_cast<Real>(0.5 * next + 0.5 * path.to);
        const auto middle = static_cast<double>(cells_.s[i]);
        cells_.s_radius[i] = upper_end(Real{}, std::max(path.to - middle, middle - next) + margin_);
    }
    counters_.form += count;
    light_.kernel.ray_form(
        cells_.batch(padded(count), frustum_, light_.scene.uniforms.template boxes<Real>()));
}

template <class Real>
auto PathSearch<Real>::judge(const LightPath& path, std::size_t i) const -> Verdict {
    const Real steepness = std::abs(cells_.k[2][i]);
    const Real size = std::abs(cells_.c[i]);
    if (cells_.nowhere[i] != 0 || size > steepness + cells_.e[i]) return Verdict::Free;
    const bool continuous = cells_.continuous[i] != 0;
    if (continuous && steepness > size + cells_.e[i])
        return Verdict::Dark;  // opposite signs at the ends
    if (path.to - path.next() > finest_) return Verdict::Open;
    return continuous ? Verdict::Dark : Verdict::Free;
}

template <class Real>
void PathSearch<Real>::search(std::vector<LightPath>& paths) {
    std::vector<LightPath> free;
    while (!paths.empty()) {
        std::size_t kept = 0;
        for (std::size_t first = 0; first < paths.size(); first += cells_at_once) {
            if (light_.stopped()) return;
            const std::size_t count = std::min(cells_at_once, paths.size() - first);
            evaluate(&paths[first], count);
            for (std::size_t i = 0; i < count; ++i) {
                LightPath path = paths[first + i];
                switch (judge(path, i)) {
                    case Verdict::Dark:
                        path.layer->any_dark = true;
                        path.layer->key_light[path.pixel] = 0.0F;
                        continue;
                    case Verdict::Free:
                        path.to = path.next();
                        path.step += path.step;
                        if (!(path.from < path.to)) {
                            free.push_back({.layer = path.layer,
                                            .pixel = path.pixel,
                                            .u = path.u,
                                            .v = path.v,
                                            .from = path.from,
                                            .end = path.end});
                            continue;
                        }
                        break;
                    case Verdict::Open: path.step = 0.5 * (path.to - path.next()); break;
                }
                paths[kept++] = path;
            }
        }
        paths.resize(kept);
    }
    paths = std::move(free);
}

/// The paths of a tile's hits to the light.
class PathMaker {
public:
    PathMaker(const TraceFrame& frame, const Tile& tile, const ViewFrame& light,
              const TileRays& light_rays)
        : frame_(frame), tile_(tile), light_(light), light_rays_(light_rays) {
        const double cell = frame.scene.clip.size() * std::ldexp(1.0, -frame.depth.wanted);
        const double extent = std::min(frame.scene.clip.size(), frame.view.look_distance);
        bias_ = std::max(0x1p-12 * extent, 6 * cell);
        finest = std::max(0x1p-14 * extent, 4 * cell);
    }

    /// Adds the paths that leave the lit side of the surface.
    void add(LitLayer& layer, std::vector<LightPath>& paths) const;

    double finest;  ///< see PathSearch; Knoll's d_stop - 2 at most

private:
    const TraceFrame& frame_;
    const Tile& tile_;
    const ViewFrame& light_;
    const TileRays& light_rays_;
    double bias_;  ///< how far off the surface a path begins, and more the more it slants
};

void PathMaker::add(LitLayer& layer, std::vector<LightPath>& paths) const {
    const TileHits& hits = *layer.hits;
    for (int row = 0; row < tile_.rows; ++row) {
        for (int col = 0; col < tile_.cols; ++col) {
            const auto at = static_cast<std::size_t>(row * tile_size + col);
            if (!(hits.depth[at] < std::numeric_limits<float>::infinity())) continue;
            const PixelPoint centre = pixel_centre(tile_.col + col, tile_.row + row);
            const glm::dvec3 along = frame_.view.direction(centre, frame_.image);
            const glm::dvec3 from_light =
                frame_.view.point(centre, frame_.image, static_cast<double>(hits.depth[at])) -
                light_.eye;
            const glm::dvec3 gradient(hits.gradient[0][at], hits.gradient[1][at],
                                      hits.gradient[2][at]);
            const double slant =
                glm::dot(gradient, from_light) / (glm::length(gradient) * glm::length(from_light));
            const double lit = glm::dot(gradient, along) > 0 ? slant : -slant;
            if (!(lit > 0)) continue;
            const double distance = glm::dot(from_light, light_.forward);
            const double u = glm::dot(from_light, light_.right) / distance;
            const double v = glm::dot(from_light, light_.up) / distance;
            const double from = light_rays_.depths(u, v, 0.0, 0.0).enter_lo;
            const double to = distance - light_.look_distance - bias_ / std::max(lit, 0.1);
            if (!(from < to)) continue;
            paths.push_back(
                {.layer = &layer, .pixel = at, .u = u, .v = v, .from = from, .end = to});
        }
    }
}

}  // namespace

glm::dvec3 shadow_light(const ViewFrame& view, const Box& clip) {
    return look_point(view) + light_distance * lit_radius(view, clip) * key_light(view);
}

void find_shadows(std::span<const TraceFrame> surfaces, const TimeLimit& limit, const Tile& tile,
                  std::span<LitLayer> layers, Counters& counters) {
    thread_local std::vector<LightPath> paths;
    paths.clear();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const TraceFrame light = light_frame(surfaces[i], limit);
        const TileRays light_rays(light, light_tile);
        const PathMaker maker(surfaces[i], tile, light.view, light_rays);
        if (i == 0) {
            for (LitLayer& layer : layers)
                maker.add(layer, paths);
        }
        if (surfaces[i].precision == Precision::Double) {
            PathSearch<double>(light, light_rays, maker.finest, counters).search(paths);
        } else {
            PathSearch<float>(light, light_rays, maker.finest, counters).search(paths);
        }
    }
}

}  // namespace zeroset
