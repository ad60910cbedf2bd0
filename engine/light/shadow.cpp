#include "engine/light/shadow.hpp"

#include "engine/kernel/form_cells.hpp"
#include "engine/light/shade.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/beam_view.hpp"

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

/// A hit on its way to the light: rays of the light, from the back.
struct Way {
    TileHits* hits;
    std::size_t pixel;
    double u, v;                         ///< of the light's ray through the hit
    double from, end;                    ///< depths, from the light
    double to = end;                     ///< not searched yet: from `from` to here
    double step = 0.125 * (end - from);  ///< of the next cell, at `to`

    [[nodiscard]] double next() const { return std::max(from, to - step); }
};

/// How far the light is, in radii of what it lights.
constexpr double light_distance = 16.0;

glm::dvec3 look_point(const ViewFrame& view) {
    return view.eye + view.look_distance * view.forward;
}

/// Of a sphere about the point looked at that holds the clip box.
double lit_radius(const ViewFrame& view, const Box& clip) {
    const glm::dvec3 middle = look_point(view);
    return glm::length(glm::max(glm::abs(clip.lo - middle), glm::abs(clip.hi - middle)));
}

/// The light as an eye that sees the whole clip box.
Camera light_camera(const TraceFrame& frame) {
    const double half_height = 1.01 / (light_distance - 1.0);
    return {shadow_light(frame.view, frame.scene.clip), look_point(frame.view), frame.view.up,
            2.0 * std::atan(half_height)};
}

/// What the light sees: one tile, whose pixels do not matter.
TraceFrame light_frame(const TraceFrame& frame, const TimeLimit& limit) {
    return {frame.scene, frame.kernel,    ViewFrame(light_camera(frame)),
            tile_size,   tile_size,       frame.stop,
            frame.depth, frame.precision, limit};
}

constexpr Tile light_tile{0, 0, tile_size, tile_size};

/// Searches ways for the roots of one surface.
template <class Real>
class WaySearch {
public:
    WaySearch(const TraceFrame& light, const BeamView& view, double finest, Counters& counters)
        : light_(light),
          counters_(counters),
          frustum_(view.frustum<Real>(1)),
          finest_(finest),
          margin_(view.depth_error()) {}

    /// Takes away the ways on which there is a root: their hits are in the shadow.
    void search(std::vector<Way>& ways);

private:
    enum class Verdict : std::uint8_t { Free, Dark, Open };

    void evaluate(const Way* ways, std::size_t count);
    [[nodiscard]] Verdict judge(const Way& way, std::size_t i) const;

    const TraceFrame& light_;
    Counters& counters_;
    FrustumOf<Real> frustum_;
    double finest_;  ///< a cell that is no longer and may hold a root throws a shadow
    double margin_;  ///< cells are longer than their part of the way
    FormCells<Real, cells_at_once> cells_;
};

template <class Real>
void WaySearch<Real>::evaluate(const Way* ways, std::size_t count) {
    const std::size_t padded = (count + batch_multiple - 1) / batch_multiple * batch_multiple;
    for (std::size_t i = 0; i < padded; ++i) {
        const Way& way = ways[std::min(i, count - 1)];
        const double next = way.next();
        cells_.u[i] = static_cast<Real>(way.u);
        cells_.v[i] = static_cast<Real>(way.v);
        cells_.s[i] = static_cast<Real>(0.5 * next + 0.5 * way.to);
        const auto middle = static_cast<double>(cells_.s[i]);
        cells_.s_radius[i] = upper_end(Real{}, std::max(way.to - middle, middle - next) + margin_);
    }
    counters_.form += count;
    light_.kernel.ray_form(
        cells_.batch(padded, frustum_, light_.scene.uniforms.template boxes<Real>()));
}

template <class Real>
auto WaySearch<Real>::judge(const Way& way, std::size_t i) const -> Verdict {
    const Real steepness = std::abs(cells_.k[2][i]);
    const Real size = std::abs(cells_.c[i]);
    if (cells_.nowhere[i] != 0 || size > steepness + cells_.e[i]) return Verdict::Free;
    const bool continuous = cells_.continuous[i] != 0;
    if (continuous && steepness > size + cells_.e[i])
        return Verdict::Dark;  // opposite signs at the ends
    if (way.to - way.next() > finest_) return Verdict::Open;
    return continuous ? Verdict::Dark : Verdict::Free;
}

template <class Real>
void WaySearch<Real>::search(std::vector<Way>& ways) {
    std::vector<Way> free;
    while (!ways.empty()) {
        std::size_t kept = 0;
        for (std::size_t first = 0; first < ways.size(); first += cells_at_once) {
            if (light_.stopped()) return;
            const std::size_t count = std::min(cells_at_once, ways.size() - first);
            evaluate(&ways[first], count);
            for (std::size_t i = 0; i < count; ++i) {
                Way way = ways[first + i];
                switch (judge(way, i)) {
                    case Verdict::Dark:
                        way.hits->any_dark = true;
                        way.hits->lit[way.pixel] = 0.0F;
                        continue;
                    case Verdict::Free:
                        way.to = way.next();
                        way.step += way.step;
                        if (!(way.from < way.to)) {
                            free.push_back({way.hits, way.pixel, way.u, way.v, way.from, way.end});
                            continue;
                        }
                        break;
                    case Verdict::Open: way.step = 0.5 * (way.to - way.next()); break;
                }
                ways[kept++] = way;
            }
        }
        ways.resize(kept);
    }
    ways = std::move(free);
}

/// The ways of a tile's hits to the light.
class WayMaker {
public:
    WayMaker(const TraceFrame& frame, const Tile& tile, const ViewFrame& light,
             const BeamView& light_view)
        : frame_(frame), tile_(tile), light_(light), light_view_(light_view) {
        const double cell = frame.scene.clip.size() * std::ldexp(1.0, -frame.depth.wanted);
        const double extent = std::min(frame.scene.clip.size(), frame.view.look_distance);
        bias_ = std::max(0x1p-12 * extent, 6 * cell);
        finest = std::max(0x1p-14 * extent, 4 * cell);
    }

    /// Those that leave the lit side of the surface.
    void add(TileHits& hits, std::vector<Way>& ways) const;

    double finest;  ///< see WaySearch; Knoll's d_stop - 2 at most

private:
    const TraceFrame& frame_;
    const Tile& tile_;
    const ViewFrame& light_;
    const BeamView& light_view_;
    double bias_;  ///< how far off the surface a way begins, and more the more it slants
};

void WayMaker::add(TileHits& hits, std::vector<Way>& ways) const {
    for (int row = 0; row < tile_.rows; ++row) {
        for (int col = 0; col < tile_.cols; ++col) {
            const auto at = static_cast<std::size_t>(row * tile_size + col);
            if (!(hits.depth[at] < std::numeric_limits<float>::infinity())) continue;
            const double image_col = tile_.col + col + 0.5;
            const double image_row = tile_.row + row + 0.5;
            const glm::dvec3 along =
                frame_.view.direction(image_col, image_row, frame_.width, frame_.height);
            const glm::dvec3 from_light =
                frame_.view.point(image_col, image_row, frame_.width, frame_.height,
                                  static_cast<double>(hits.depth[at])) -
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
            const double from = light_view_.depths(u, v, 0.0, 0.0).enter_lo;
            const double to = distance - light_.look_distance - bias_ / std::max(lit, 0.1);
            if (from < to) ways.push_back({&hits, at, u, v, from, to});
        }
    }
}

}  // namespace

glm::dvec3 shadow_light(const ViewFrame& view, const Box& clip) {
    return look_point(view) + light_distance * lit_radius(view, clip) * key_light(view);
}

void find_shadows(std::span<const TraceFrame> surfaces, const TimeLimit& limit, const Tile& tile,
                  std::span<TileHits> hits, Counters& counters) {
    thread_local std::vector<Way> ways;
    ways.clear();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const TraceFrame light = light_frame(surfaces[i], limit);
        const BeamView light_view(light, light_tile);
        const WayMaker maker(surfaces[i], tile, light.view, light_view);
        if (i == 0) {
            for (TileHits& of_surface : hits.first(surfaces.size())) {
                if (of_surface.any) maker.add(of_surface, ways);
            }
        }
        if (surfaces[i].precision == Precision::Double) {
            WaySearch<double>(light, light_view, maker.finest, counters).search(ways);
        } else {
            WaySearch<float>(light, light_view, maker.finest, counters).search(ways);
        }
    }
}

}  // namespace zeroset
