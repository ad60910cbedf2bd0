#include "engine/kernel/point_batch.hpp"
#include "engine/light/tile_light.hpp"
#include "engine/trace/hit_gradients.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace zeroset {
namespace {

constexpr float ink = 0.04F;  ///< the part of the light that a line leaves
/// Contours nearer to each other than this many widths fade, and are gone at the first.
constexpr double closest_widths = 1.5;
constexpr double fair_widths = 3.5;
/// Normals whose angle has a smaller cosine belong to two sides of a crease.
constexpr double crease_cosine = 0.82;
/// Where a surface is seen more from aside a pixel is too long on it to tell creases from bends.
constexpr double least_crease_facing = 0.15;

/// A hit of a layer, on its tangent plane.
struct Place {
    std::size_t pixel;
    glm::dvec3 point, normal;
    glm::dvec3 along;        ///< of the ray, of length 1
    glm::dvec3 right, down;  ///< on the tangent plane, a pixel to the right and downwards
    double facing;           ///< the cosine between normal and ray, at least 0

    /// How fast a number of this gradient changes on the plane from pixel to pixel.
    [[nodiscard]] double rate_of(const glm::dvec3& gradient) const {
        return std::hypot(glm::dot(gradient, right), glm::dot(gradient, down));
    }
};

/// The part of a pixel that a line of this width covers, at a distance in pixels.
double cover_of(double distance, double width) {
    return std::clamp(0.5 * width + 0.5 - distance, 0.0, std::min(width, 1.0));
}

class LinePainter {
public:
    LinePainter(std::span<const TraceFrame> surfaces, int fineness, const Tile& tile,
                LitLayer& layer, Counters& counters)
        : surfaces_(surfaces),
          frame_(surfaces[layer.surface]),
          lines_(frame_.scene.coloring.lines),
          line_width_(fineness * static_cast<double>(lines_.width_px)),
          tile_(tile),
          layer_(layer),
          counters_(counters) {
        list_places();
        cover_.resize(places_.size());
    }

    [[nodiscard]] bool has_places() const { return !places_.empty(); }
    void draw_contours();
    void draw_intersections();
    void draw_outlines();
    /// Draws what the lines cover.
    void finish();

private:
    void list_places();
    void add(std::size_t i, double cover) { cover_[i] = std::max(cover_[i], cover); }
    [[nodiscard]] double width_at(const Place& place) const {
        return line_width_ * std::min(1.0, 3.0 * place.facing);
    }
    /// A number at a place, and how fast it changes from pixel to pixel.
    struct Change {
        double here, rate;
    };
    [[nodiscard]] std::vector<Change> changes_of(const PointNumber& number);
    /// Calls a function at each place, and at parts of pixels to the right and below on its plane:
    /// three points each, one after the other. `part_of(place)`: of a pixel.
    template <class PartOf>
    PointBatch<double> values_beside(std::span<const Place> places, const PartOf& part_of,
                                     const PointFunction& function, PointBatch<double>::Asks asks);
    void draw_contours_of(const PointNumber& number);
    void draw_edge(const glm::dvec3& normal, double offset);
    void draw_silhouettes();
    void draw_creases();
    /// Whether the normals of hits so far from a pixel are all much like its own one.
    [[nodiscard]] bool is_smooth_around(const Place& place, int reach) const;
    /// The direction of the gradient of a pixel's hit, if there is one.
    [[nodiscard]] std::optional<glm::dvec3> normal_of(std::size_t pixel) const;

    std::span<const TraceFrame> surfaces_;
    const TraceFrame& frame_;
    const SurfaceLines& lines_;
    double line_width_;  ///< pixels of the tile
    const Tile& tile_;
    LitLayer& layer_;
    Counters& counters_;
    std::vector<Place> places_;
    std::vector<double> cover_;  ///< of each place
};

std::optional<glm::dvec3> LinePainter::normal_of(std::size_t pixel) const {
    const glm::dvec3 gradient = layer_.hits->gradient_at(pixel);
    const double size = glm::length(gradient);
    if (!(size > 0.0) || !std::isfinite(size)) return std::nullopt;
    return gradient / size;
}

template <class PartOf>
PointBatch<double> LinePainter::values_beside(std::span<const Place> places, const PartOf& part_of,
                                              const PointFunction& function,
                                              PointBatch<double>::Asks asks) {
    PointBatch<double> batch(3 * places.size(), asks);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Place& place = places[i];
        const double part = part_of(place);
        const std::array points{place.point, place.point + part * place.right,
                                place.point + part * place.down};
        for (std::size_t k = 0; k < 3; ++k)
            batch.set(3 * i + k, points[k].x, points[k].y, points[k].z);
    }
    batch.pad();
    counters_.value += 3 * places.size();
    batch.evaluate(function, frame_.scene.uniforms.points<double>(),
                   [this] { return frame_.stopped(); });
    return batch;
}

void LinePainter::list_places() {
    const ViewFrame& view = frame_.view;
    const auto add_place = [&](std::size_t pixel, const PixelRay& ray, double distance) {
        const auto normal = normal_of(pixel);
        if (!normal) return;
        const glm::dvec3 along = ray.direction;
        const glm::dvec3 point = ray.at(distance);
        const double cosine = glm::dot(*normal, along);
        if (std::abs(cosine) < 1e-6) return;
        const double depth = glm::dot(point - view.eye, view.forward);
        const double pixel_size = view.pixel_width(frame_.image.height, depth);
        const auto on_plane = [&](const glm::dvec3& step) {
            return pixel_size * (step - along * (glm::dot(*normal, step) / cosine));
        };
        places_.push_back({.pixel = pixel,
                           .point = point,
                           .normal = cosine > 0.0 ? -*normal : *normal,
                           .along = along,
                           .right = on_plane(view.right),
                           .down = on_plane(-view.up),
                           .facing = std::abs(cosine)});
    };
    for_each_hit(frame_, tile_, *layer_.hits, add_place);
}

std::vector<LinePainter::Change> LinePainter::changes_of(const PointNumber& number) {
    std::vector<Change> changes;
    changes.reserve(places_.size());
    if (!number.code) {
        for (const Place& place : places_)
            changes.push_back(
                {.here = glm::dot(number.along, place.point), .rate = place.rate_of(number.along)});
        return changes;
    }
    constexpr double part = 0.25;
    const auto some = [](const Place& /*place*/) { return part; };
    const PointBatch<double> batch =
        values_beside(places_, some, number.code, PointBatch<double>::Asks::Value);
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const double here = batch.f(3 * i);
        changes.push_back(
            {.here = here,
             .rate = std::hypot(batch.f(3 * i + 1) - here, batch.f(3 * i + 2) - here) / part});
    }
    return changes;
}

void LinePainter::draw_contours_of(const PointNumber& number) {
    const std::vector<Change> changes = changes_of(number);
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const auto [here, rate] = changes[i];
        if (!std::isfinite(here) || !(rate < std::numeric_limits<double>::infinity())) continue;
        const double spacing = lines_.step / rate;  // pixels
        const double steps = here / lines_.step;
        const double distance = std::abs(steps - std::round(steps)) * spacing;
        const double width = width_at(places_[i]);
        const double fade = std::clamp(
            (spacing / width - closest_widths) / (fair_widths - closest_widths), 0.0, 1.0);
        add(i, fade * cover_of(distance, width));
    }
}

void LinePainter::draw_contours() {
    for (const PointNumber& number : lines_.contours)
        draw_contours_of(number);
}

void LinePainter::draw_intersections() {
    const std::size_t count = places_.size();
    PointBatch<double> batch(count);
    for (std::size_t i = 0; i < count; ++i)
        batch.set(i, places_[i].point.x, places_[i].point.y, places_[i].point.z);
    batch.pad();
    for (const TraceFrame& other : surfaces_) {
        if (&other == &frame_) continue;
        counters_.value += count;
        batch.evaluate(other.kernel.in_double.value, frame_.scene.uniforms.points<double>(),
                       [this] { return frame_.stopped(); });
        for (std::size_t i = 0; i < count; ++i) {
            const Place& place = places_[i];
            const glm::dvec3 gradient(batch.gradient(0, i), batch.gradient(1, i),
                                      batch.gradient(2, i));
            const double distance = std::abs(batch.f(i)) / place.rate_of(gradient);
            if (std::isfinite(distance)) add(i, cover_of(distance, 2.0 * width_at(place)));
        }
    }
}

/// Draws the edge where a plane cuts the surface off.
void LinePainter::draw_edge(const glm::dvec3& normal, double offset) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Place& place = places_[i];
        if (layer_.hits->is_cap(place.pixel)) continue;
        const double distance = (offset - glm::dot(normal, place.point)) / place.rate_of(normal);
        if (distance < line_width_ + 1.0)
            add(i, cover_of(std::abs(distance), 2.0 * width_at(place)));
    }
}

/// Near a silhouette the square of the cosine between normal and ray falls evenly to 0: how fast,
/// the normals a little beside the hit tell.
void LinePainter::draw_silhouettes() {
    std::vector<std::size_t> at;
    std::vector<Place> slanted;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (!(places_[i].facing < 0.5)) continue;
        at.push_back(i);
        slanted.push_back(places_[i]);
    }
    if (slanted.empty()) return;
    const auto part_of = [](const Place& place) { return 0.05 * place.facing; };
    const PointBatch<double> batch = values_beside(slanted, part_of, frame_.kernel.in_double.value,
                                                   PointBatch<double>::Asks::Gradient);
    for (std::size_t i = 0; i < slanted.size(); ++i) {
        const auto square_at = [&](std::size_t point) {
            const glm::dvec3 gradient(batch.gradient(0, point), batch.gradient(1, point),
                                      batch.gradient(2, point));
            const double cosine = glm::dot(gradient, slanted[i].along) / glm::length(gradient);
            return cosine * cosine;
        };
        const double here = square_at(3 * i);
        const double rate = std::hypot(square_at(3 * i + 1) - here, square_at(3 * i + 2) - here) /
                            part_of(slanted[i]);
        const double distance = here / rate;
        if (std::isfinite(distance)) add(at[i], cover_of(distance, 2.0 * line_width_));
    }
}

bool LinePainter::is_smooth_around(const Place& place, int reach) const {
    if (tile_.places != nullptr) return false;  // pixels are no neighbours
    const auto is_alike = [&](int right, int down) {
        const int col = static_cast<int>(place.pixel % tile_size) + right;
        const int row = static_cast<int>(place.pixel / tile_size) + down;
        if (col < 0 || row < 0 || col >= tile_.cols || row >= tile_.rows) return false;
        const auto beside = static_cast<std::size_t>(row * tile_size + col);
        if (!std::isfinite(layer_.hits->depth[beside])) return false;
        const auto normal = normal_of(beside);
        return normal && std::abs(glm::dot(*normal, place.normal)) >= crease_cosine;
    };
    return is_alike(reach, 0) && is_alike(-reach, 0) && is_alike(0, reach) && is_alike(0, -reach);
}

/// Beyond a crease f follows the surface's other side, on the tangent plane of this one, too: f and
/// its gradient at a point there tell the other side's plane, and so how far the crease is.
void LinePainter::draw_creases() {
    // One of four points across comes this far behind any straight line.
    const double reach = std::numbers::sqrt2 * (0.5 * line_width_ + 0.5);
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (places_[i].facing < least_crease_facing) continue;
        if (!is_smooth_around(places_[i], static_cast<int>(std::ceil(reach)))) at.push_back(i);
    }
    if (at.empty()) return;
    const auto step_to = [&](const Place& place, std::size_t k) {
        return (k < 2 ? reach : -reach) * (k % 2 == 0 ? place.right : place.down);
    };
    PointBatch<double> batch(4 * at.size());
    for (std::size_t i = 0; i < 4 * at.size(); ++i) {
        const Place& place = places_[at[i / 4]];
        const glm::dvec3 point = place.point + step_to(place, i % 4);
        batch.set(i, point.x, point.y, point.z);
    }
    batch.pad();
    counters_.value += 4 * at.size();
    batch.evaluate(frame_.kernel.in_double.value, frame_.scene.uniforms.points<double>(),
                   [this] { return frame_.stopped(); });
    for (std::size_t i = 0; i < 4 * at.size(); ++i) {
        const Place& place = places_[at[i / 4]];
        const glm::dvec3 gradient(batch.gradient(0, i), batch.gradient(1, i), batch.gradient(2, i));
        const double cosine = glm::dot(gradient, place.normal) / glm::length(gradient);
        if (!(std::abs(cosine) < crease_cosine)) continue;
        const double here = batch.f(i) - glm::dot(gradient, step_to(place, i % 4));
        const double distance = std::abs(here) / place.rate_of(gradient);
        if (std::isfinite(distance)) add(at[i / 4], cover_of(distance, line_width_));
    }
}

void LinePainter::draw_outlines() {
    draw_silhouettes();
    draw_creases();
    const Scene& scene = frame_.scene;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 normal(0.0);
        normal[axis] = 1.0;
        draw_edge(normal, scene.clip.hi[axis]);
        draw_edge(-normal, -scene.clip.lo[axis]);
    }
    for (const Section& section : scene.region.sections)
        draw_edge(section.normal, section.offset);
    if (!scene.region.ball) return;
    const Ball& ball = *scene.region.ball;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Place& place = places_[i];
        const glm::dvec3 from = place.point - ball.centre;
        const double left =
            0.5 * (ball.radius * ball.radius - glm::dot(from, from)) / place.rate_of(from);
        if (left < line_width_ + 1.0) add(i, cover_of(std::abs(left), 2.0 * width_at(place)));
    }
}

void LinePainter::finish() {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (!(cover_[i] > 0.0)) continue;
        const std::size_t pixel = places_[i].pixel;
        const auto row = static_cast<int>(pixel / tile_size);
        const auto cover = static_cast<float>(std::min(cover_[i], 1.0));
        for (int channel = 0; channel < 3; ++channel) {
            float& light = layer_.light_row(row, channel)[pixel % tile_size];
            light += cover * (ink * std::min(light, 1.0F) - light);
        }
        if (!layer_.cover.empty()) layer_.cover[pixel] += cover * (1.0F - layer_.cover[pixel]);
    }
}

}  // namespace

void draw_lines(std::span<const TraceFrame> surfaces, int fineness, const Tile& tile,
                std::span<LitLayer> layers, Counters& counters) {
    const Scene& scene = surfaces.front().scene;
    const SurfaceLines& lines = scene.coloring.lines;
    for (LitLayer& layer : layers) {
        const bool outlines = look_of(scene, layer.surface) == Look::Technical;
        if (!lines.any() && !outlines) continue;
        LinePainter painter(surfaces, fineness, tile, layer, counters);
        if (!painter.has_places()) continue;
        painter.draw_contours();
        if (lines.intersections) painter.draw_intersections();
        if (outlines) painter.draw_outlines();
        painter.finish();
    }
}

}  // namespace zeroset
