#include "ui/picture/picture_marks.hpp"

#include "document/look.hpp"
#include "engine/annotate/hidden.hpp"
#include "engine/annotate/legend.hpp"
#include "engine/annotate/markers.hpp"
#include "engine/view/pixel_ray.hpp"
#include "ui/picture/draw_shapes.hpp"

#include <glm/glm.hpp>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

/// Name and place of the selected marker.
std::string full_text(const Marker& marker, const ShownPicture& picture) {
    return name_of(marker) + "  " + coordinates_text(marker.at, marker_resolution(marker, picture));
}

std::vector<MarkedPoint> marked_points(const Edited& edited, const Shown& shown) {
    const ShownPicture& picture = shown.picture;
    std::vector<MarkedPoint> points;
    const ViewFrame view(picture.camera);
    for (const ShownPoint& point : shown.points) {
        if (point.name.empty()) continue;
        points.push_back(
            {.at = before_ball(view, point.at, point.radius), .words = point.name, .dot = false});
    }
    for (const Marker& marker : edited.document.markers) {
        const bool selected = marker.number == edited.selected_marker;
        points.push_back({.at = marker.at,
                          .words = selected ? full_text(marker, picture) : name_of(marker),
                          .selected = selected});
    }
    return points;
}

}  // namespace

double marker_resolution(const Marker& marker, const ShownPicture& picture) {
    if (picture.frame == nullptr) {
        const glm::dvec3 size = glm::abs(marker.at);
        const double reach = std::max({size.x, size.y, size.z, 1e-300});
        return 1e-4 * std::pow(10.0, std::floor(std::log10(reach)));
    }
    const ViewFrame view(picture.camera);
    return 0.1 * view.pixel_width(std::max(picture.frame->height, 1), view.distance_of(marker.at));
}

void draw_picture_marks(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi,
                        const Edited& edited, const Shown& shown) {
    const ShownPicture& picture = shown.picture;
    const CardStyle style = card_style(edited.theme);
    const glm::dvec2 size(hi.x - lo.x, hi.y - lo.y);
    Shapes shapes = picture.contour_labels;
    if (picture.frame != nullptr) {
        append(shapes,
               marker_shapes(marked_points(edited, shown),
                             {.frame = *picture.frame, .camera = picture.camera, .size = size},
                             style));
    }
    const CornerLegend legend{
        .legend = picture.legend ? &*picture.legend : nullptr,
        .sections = picture.section_legend ? &*picture.section_legend : nullptr,
        .undecided = edited.document.mark_undecided,
        .coarse = shown.figures.counts.coarse > 0};
    const glm::dvec2 margin(style.unit);
    append(shapes, legend_shapes(legend, size - margin, size - 2.0 * margin, style));
    canvas.PushClipRect(lo, hi, true);
    draw_shapes(canvas, lo, shapes);
    canvas.PopClipRect();
}

int marker_under(const std::vector<Marker>& markers, const ShownPicture& picture,
                 const ViewPoint& cursor, double reach) {
    if (picture.frame == nullptr) return 0;
    const ViewFrame view(picture.camera);
    int nearest = 0;
    for (const Marker& marker : markers) {
        const auto seen = place_in_view(view, marker.at);
        if (!seen || is_behind(*picture.frame, view, marker.at)) continue;
        const double off = std::hypot(seen->place.x - cursor.x, seen->place.y - cursor.y);
        if (off > reach) continue;
        reach = off;
        nearest = marker.number;
    }
    return nearest;
}

}  // namespace zeroset::ui
