#include "ui/model/point_drag.hpp"

#include "engine/view/pixel_ray.hpp"
#include "ui/model/drag_places.hpp"
#include "ui/model/edited.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset::ui {
namespace {

double stepped(const Slider& slider, double value) {
    return slider.lo + std::round((value - slider.lo) / slider.step) * slider.step;
}

}  // namespace

Sliders sliders_of(const ShownPoint& point, const Document& document) {
    Sliders sliders;
    for (const std::string& name : point.sliders) {
        if (name.empty()) continue;
        sliders[name] = slider_named(document, name);
    }
    return sliders;
}

void take_over(Document& document, const Sliders& sliders) {
    for (const auto& [name, slider] : sliders)
        set_slider(document, name, slider);
}

const ShownPoint* point_under(std::span<const ShownPoint> points, const ViewFrame& view,
                              const ViewPoint& cursor, double reach) {
    const ShownPoint* nearest = nullptr;
    for (const ShownPoint& point : points) {
        if (!point.is_movable()) continue;
        const auto seen = place_in_view(view, point.at);
        if (!seen) continue;
        const double off = std::hypot(seen->place.x - cursor.x, seen->place.y - cursor.y);
        if (off > reach) continue;
        reach = off;
        nearest = &point;
    }
    return nearest;
}

PointDrag grabbed(const ShownPoint& point, const Document& document, const ViewFrame& view,
                  const ViewPoint& cursor) {
    const Sliders sliders = sliders_of(point, document);
    PointDrag drag{.point = point, .start = sliders, .last = sliders, .off = {}};
    if (const auto seen = place_in_view(view, point.at))
        drag.off = {.x = seen->place.x - cursor.x, .y = seen->place.y - cursor.y};
    return drag;
}

Sliders dragged(const PointDrag& drag, const ViewFrame& view, const ViewPoint& cursor,
                int height_px) {
    const auto seen = place_in_view(view, drag.point.at);
    if (!seen || height_px <= 0) return drag.last;
    const ViewPoint place{.x = cursor.x + drag.off.x, .y = cursor.y + drag.off.y};
    const glm::dvec3 to = across_view(view, drag.point.at, place);
    const double pixel = view.pixel_width(height_px, seen->distance);
    Sliders sliders = drag.start;
    for (auto& [name, slider] : sliders) {
        double sum = 0.0;
        double unit = pixel;
        int count = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            if (drag.point.sliders.at(k) != name) continue;
            sum += to[static_cast<int>(k)];
            unit = pixel / view.stretch[static_cast<int>(k)];
            ++count;
        }
        const double value = std::clamp(sum / count, -largest_number, largest_number);
        set_value(slider,
                  slider.step > 0.0 ? stepped(slider, value) : rounded_to_pixel(value, unit));
    }
    return sliders;
}

}  // namespace zeroset::ui
