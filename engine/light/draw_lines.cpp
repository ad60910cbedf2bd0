#include "engine/light/draw_lines.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/view/pixel_ray.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr float ink = 0.04F;  ///< the part of the light that a line leaves
/// Contours nearer to each other than this many widths fade, and are gone at the first.
constexpr double closest_widths = 1.5;
constexpr double fair_widths = 3.5;
/// Normals of neighbours whose angle has a smaller cosine belong to two sides of a crease.
constexpr double crease_cosine = 0.82;

/// A hit of a layer, on its tangent plane.
struct Place {
    std::size_t pixel;
    glm::dvec3 point, normal;
    glm::dvec3 along;        ///< of the ray, of length 1
    glm::dvec3 right, down;  ///< on the tangent plane, a pixel to the right and downwards
    double facing;           ///< the cosine between normal and ray, at least 0
    double pixel_size;       ///< world units
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
    void draw_contours_of(const PointNumber& number);
    void draw_edge(const glm::dvec3& normal, double offset);
    void draw_silhouettes();
    void draw_creases();
    [[nodiscard]] std::optional<glm::dvec3> normal_at(int col, int row) const;

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

void LinePainter::list_places() {
    const TileHits& hits = *layer_.hits;
    const ViewFrame& view = frame_.view;
    for (int row = 0; row < tile_.rows; ++row) {
        for (int col = 0; col < tile_.cols; ++col) {
            const auto pixel = static_cast<std::size_t>(row * tile_size + col);
            const auto distance = static_cast<double>(hits.depth[pixel]);
            if (!std::isfinite(distance)) continue;
            const glm::dvec3 gradient(hits.gradient[0][pixel], hits.gradient[1][pixel],
                                      hits.gradient[2][pixel]);
            const double size = glm::length(gradient);
            if (!(size > 0.0) || !std::isfinite(size)) continue;
            const PixelRay ray = pixel_ray(view, tile_.place(col, row), frame_.image);
            const glm::dvec3 along = ray.direction;
            const glm::dvec3 point = ray.at(distance);
            const glm::dvec3 normal = gradient / size;
            const double cosine = glm::dot(normal, along);
            if (std::abs(cosine) < 1e-6) continue;
            const double depth = glm::dot(point - view.eye, view.forward);
            const double pixel_size = view.pixel_width(frame_.image.height, depth);
            const auto on_plane = [&](const glm::dvec3& step) {
                return pixel_size * (step - along * (glm::dot(normal, step) / cosine));
            };
            places_.push_back({.pixel = pixel,
                               .point = point,
                               .normal = cosine > 0.0 ? -normal : normal,
                               .along = along,
                               .right = on_plane(view.right),
                               .down = on_plane(-view.up),
                               .facing = std::abs(cosine),
                               .pixel_size = pixel_size});
        }
    }
}

void LinePainter::draw_contours_of(const PointNumber& number) {
    const std::size_t count = places_.size();
    std::vector<std::array<double, 3>> values(count);  // there, to the right, below
    if (number.code) {
        PointBatch<double> batch(3 * count, PointBatch<double>::Asks::Value);
        for (std::size_t i = 0; i < count; ++i) {
            const Place& place = places_[i];
            const std::array points{place.point, place.point + 0.25 * place.right,
                                    place.point + 0.25 * place.down};
            for (std::size_t k = 0; k < 3; ++k)
                batch.set(3 * i + k, points[k].x, points[k].y, points[k].z);
        }
        batch.pad();
        counters_.value += 3 * count;
        batch.evaluate(number.code, frame_.scene.uniforms.points<double>(),
                       [this] { return frame_.stopped(); });
        for (std::size_t i = 0; i < count; ++i) {
            const double here = batch.f(3 * i);
            values[i] = {here, 4.0 * (batch.f(3 * i + 1) - here),
                         4.0 * (batch.f(3 * i + 2) - here)};
        }
    } else {
        for (std::size_t i = 0; i < count; ++i) {
            const Place& place = places_[i];
            values[i] = {glm::dot(number.along, place.point), glm::dot(number.along, place.right),
                         glm::dot(number.along, place.down)};
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto [here, right, down] = values[i];
        const double rate = std::hypot(right, down);  // a pixel
        const double spacing = lines_.step / rate;    // pixels
        if (!std::isfinite(here) || !(rate < std::numeric_limits<double>::infinity())) continue;
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
    if (count == 0) return;
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
            const double rate =
                std::hypot(glm::dot(gradient, place.right), glm::dot(gradient, place.down));
            const double distance = std::abs(batch.f(i)) / rate;
            if (std::isfinite(distance)) add(i, cover_of(distance, 2.0 * width_at(place)));
        }
    }
}

/// Draws the edge where a plane cuts the surface off.
void LinePainter::draw_edge(const glm::dvec3& normal, double offset) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Place& place = places_[i];
        if (layer_.hits->any_cap && layer_.hits->cap[place.pixel] != 0) continue;
        const double rate = std::hypot(glm::dot(normal, place.right), glm::dot(normal, place.down));
        const double distance = (offset - glm::dot(normal, place.point)) / rate;
        if (distance < line_width_ + 1.0)
            add(i, cover_of(std::abs(distance), 2.0 * width_at(place)));
    }
}

std::optional<glm::dvec3> LinePainter::normal_at(int col, int row) const {
    if (col < 0 || row < 0 || col >= tile_.cols || row >= tile_.rows) return std::nullopt;
    const auto pixel = static_cast<std::size_t>(row * tile_size + col);
    const TileHits& hits = *layer_.hits;
    if (!std::isfinite(hits.depth[pixel])) return std::nullopt;
    const glm::dvec3 gradient(hits.gradient[0][pixel], hits.gradient[1][pixel],
                              hits.gradient[2][pixel]);
    const double size = glm::length(gradient);
    if (!(size > 0.0) || !std::isfinite(size)) return std::nullopt;
    return gradient / size;
}

/// Near a silhouette the square of the cosine between normal and ray falls evenly to 0: how fast,
/// the normals a little beside the hit tell.
void LinePainter::draw_silhouettes() {
    std::vector<std::size_t> slanted;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (places_[i].facing < 0.5) slanted.push_back(i);
    }
    if (slanted.empty()) return;
    PointBatch<double> batch(3 * slanted.size());
    const auto part_of = [](const Place& place) { return 0.05 * place.facing; };
    for (std::size_t k = 0; k < slanted.size(); ++k) {
        const Place& place = places_[slanted[k]];
        const double part = part_of(place);
        const std::array points{place.point, place.point + part * place.right,
                                place.point + part * place.down};
        for (std::size_t at = 0; at < 3; ++at)
            batch.set(3 * k + at, points[at].x, points[at].y, points[at].z);
    }
    batch.pad();
    counters_.value += 3 * slanted.size();
    batch.evaluate(frame_.kernel.in_double.value, frame_.scene.uniforms.points<double>(),
                   [this] { return frame_.stopped(); });
    for (std::size_t k = 0; k < slanted.size(); ++k) {
        const Place& place = places_[slanted[k]];
        const auto square_at = [&](std::size_t at) {
            const glm::dvec3 gradient(batch.gradient(0, 3 * k + at), batch.gradient(1, 3 * k + at),
                                      batch.gradient(2, 3 * k + at));
            const double cosine = glm::dot(gradient, place.along) / glm::length(gradient);
            return cosine * cosine;
        };
        const double here = square_at(0);
        const double rate = std::hypot(square_at(1) - here, square_at(2) - here) / part_of(place);
        const double distance = here / rate;
        if (std::isfinite(distance)) add(slanted[k], cover_of(distance, 2.0 * line_width_));
    }
}

/// Draws where the normals of neighbours on one surface differ much.
void LinePainter::draw_creases() {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Place& place = places_[i];
        if (place.facing < 0.3) continue;
        const int col = static_cast<int>(place.pixel % tile_size);
        const int row = static_cast<int>(place.pixel / tile_size);
        for (const auto& [right, down] :
             {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
            const auto normal = normal_at(col + right, row + down);
            if (normal && std::abs(glm::dot(*normal, place.normal)) < crease_cosine)
                add(i, std::min(0.5 * line_width_, 1.0));
        }
    }
}

void LinePainter::draw_outlines() {
    draw_silhouettes();
    if (tile_.places == nullptr) draw_creases();
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
        const double rate = std::hypot(glm::dot(from, place.right), glm::dot(from, place.down));
        const double left = 0.5 * (ball.radius * ball.radius - glm::dot(from, from)) / rate;
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

void draw_lines(std::span<const TraceFrame> surfaces, bool outlines, int fineness, const Tile& tile,
                std::span<LitLayer> layers, Counters& counters) {
    const SurfaceLines& lines = surfaces.front().scene.coloring.lines;
    if (!lines.any() && !outlines) return;
    for (LitLayer& layer : layers) {
        LinePainter painter(surfaces, fineness, tile, layer, counters);
        painter.draw_contours();
        if (lines.intersections) painter.draw_intersections();
        if (outlines) painter.draw_outlines();
        painter.finish();
    }
}

}  // namespace zeroset
