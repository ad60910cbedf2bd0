#include "ui/picture/picture_marks.hpp"

#include "document/look.hpp"
#include "engine/annotate/hidden.hpp"
#include "engine/annotate/legend.hpp"
#include "engine/annotate/markers.hpp"
#include "engine/view/pixel_ray.hpp"
#include "ui/picture/draw_shapes.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

/// Number and place of the selected marker, with as many decimals as tell neighbouring pixels
/// apart.
std::string full_text(const Marker& marker, const ViewFrame& view, const Framebuffer& frame) {
    const double distance = view.distance_of(marker.at);
    const double resolution = 0.1 * view.pixel_width(std::max(frame.height, 1), distance);
    return std::to_string(marker.number) + "  " + coordinates_text(marker.at, resolution);
}

std::vector<MarkedPoint> marked_points(const UiState& state) {
    const ViewFrame view(state.shown.camera);
    std::vector<MarkedPoint> points;
    for (const Marker& marker : state.document.markers) {
        const bool selected = marker.number == state.selected_marker;
        points.push_back(
            {marker.at,
             selected ? full_text(marker, view, *state.shown.frame) : std::to_string(marker.number),
             selected});
    }
    return points;
}

}  // namespace

void draw_picture_marks(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi,
                        const UiState& state) {
    const CardStyle style = card_style(state.theme);
    const glm::dvec2 size(hi.x - lo.x, hi.y - lo.y);
    Shapes shapes;
    if (state.shown.frame != nullptr) {
        shapes = marker_shapes(
            marked_points(state),
            {.frame = *state.shown.frame, .camera = state.shown.camera, .size = size}, style);
    }
    const CornerLegend legend{.legend = state.legend ? &*state.legend : nullptr,
                              .undecided = state.document.mark_undecided,
                              .coarse = state.picture.counts.coarse > 0};
    const glm::dvec2 margin(style.unit);
    append(shapes, legend_shapes(legend, size - margin, size - 2.0 * margin, style));
    canvas.PushClipRect(lo, hi, true);
    draw_shapes(canvas, lo, shapes);
    canvas.PopClipRect();
}

int marker_under(const UiState& state, const glm::dvec2& cursor, double reach) {
    if (state.shown.frame == nullptr) return 0;
    const ViewFrame view(state.shown.camera);
    int nearest = 0;
    for (const Marker& marker : state.document.markers) {
        const auto seen = place_in_view(view, marker.at);
        if (!seen || is_behind(*state.shown.frame, view, marker.at)) continue;
        const double off = std::hypot(seen->place.x - cursor.x, seen->place.y - cursor.y);
        if (off > reach) continue;
        reach = off;
        nearest = marker.number;
    }
    return nearest;
}

}  // namespace zeroset::ui
