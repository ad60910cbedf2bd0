#include "engine/image/color_map.hpp"
#include "engine/kernel/point_batch.hpp"
#include "engine/light/tile_light.hpp"
#include "engine/trace/hit_gradients.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace zeroset {
namespace {

constexpr double line_width_px = 1.5;

/// A pixel that shows a section's value.
struct ValuePixel {
    std::size_t pixel;
    glm::dvec3 normal, along;  ///< of the section, and of the ray; of length 1
    double width;              ///< of a pixel there, world units
};

/// The points of a layer that show values.
class ValuePoints {
public:
    ValuePoints(const TraceFrame& frame, const Tile& tile, const LitLayer& layer) {
        std::vector<glm::dvec3> points;
        const auto take = [&](std::size_t pixel, const PixelRay& ray, double distance) {
            if (layer.hits->cap[pixel] != CapKind::Values) return;
            pixels_.push_back({.pixel = pixel,
                               .normal = layer.hits->gradient_at(pixel),
                               .along = ray.direction,
                               .width = frame.view.pixel_width(frame.image.height, distance)});
            points.push_back(ray.at(distance));
        };
        for_each_hit(frame, tile, *layer.hits, take);
        if (points.empty()) return;
        batch_.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            batch_.set(i, points[i].x, points[i].y, points[i].z);
        batch_.pad();
    }

    [[nodiscard]] const std::vector<ValuePixel>& pixels() const { return pixels_; }
    /// Evaluates `function` at the points.
    const PointBatch<double>& evaluate(const PointFunction& function, const TraceFrame& frame) {
        batch_.evaluate(function, frame.scene.uniforms.points<double>(),
                        [&frame] { return frame.stopped(); });
        return batch_;
    }

private:
    std::vector<ValuePixel> pixels_;
    PointBatch<double> batch_;
};

/// How much of a pixel the line f = 0 on the section covers, 0 to 1.
float line_cover(const ValuePixel& at, double f, const glm::dvec3& gradient, int fineness) {
    const glm::dvec3 slope = gradient - glm::dot(gradient, at.normal) * at.normal;
    const double size = glm::length(slope);
    if (!(size > 0.0) || !std::isfinite(size)) return 0.0F;
    const glm::dvec3 across = slope / size;
    // Foreshorten the way across the line, as the eye sees it.
    const double seen = glm::length(across - glm::dot(across, at.along) * at.along);
    const double pixels = std::abs(f) / size * seen / at.width;
    const double cover = 0.5 * line_width_px * fineness + 0.5 - pixels;
    return static_cast<float>(std::clamp(cover, 0.0, 1.0));
}

}  // namespace

void show_section_values(const TraceFrame& frame, const Tile& tile, int fineness, LitLayer& layer,
                         Counters& counters) {
    if (!layer.hits->any_values) return;
    const Scene& scene = frame.scene;
    ValuePoints points(frame, tile, layer);
    const std::vector<ValuePixel>& pixels = points.pixels();
    if (pixels.empty()) return;
    static const SectionValues usual;
    const SectionValues& shown = scene.section_values ? *scene.section_values : usual;
    const PointFunction& f = frame.kernel.in_double.value;
    const PointFunction& of_side = scene.surfaces[layer.surface].section_value;
    const bool of_f = !of_side;
    const auto& numbers = points.evaluate(of_f ? f : of_side, frame);
    std::vector<Reflectance> colors;
    colors.reserve(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        colors.push_back(color_at(shown.map, shown.range.place(numbers.f(i))));
    const auto& levels = of_f ? numbers : points.evaluate(f, frame);
    counters.value += (of_f ? 1 : 2) * pixels.size();
    const float(&line)[3] = scene.colors_of_surface(layer.surface).front;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::dvec3 gradient(levels.gradient(0, i), levels.gradient(1, i),
                                  levels.gradient(2, i));
        const float cover = line_cover(pixels[i], levels.f(i), gradient, fineness);
        const auto row = static_cast<int>(pixels[i].pixel / tile_size);
        const std::size_t col = pixels[i].pixel % tile_size;
        for (int channel = 0; channel < 3; ++channel) {
            const float color = colors[i][static_cast<std::size_t>(channel)];
            layer.light_row(row, channel)[col] = color + cover * (line[channel] - color);
        }
        if (!layer.cover.empty()) layer.cover[pixels[i].pixel] = 1.0F;
    }
}

}  // namespace zeroset
