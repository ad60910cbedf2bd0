#include "document/look.hpp"
#include "engine/annotate/hidden.hpp"
#include "engine/annotate/markers.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/view/pixel_ray.hpp"
#include "ui/picture/draw_shapes.hpp"
#include "ui/picture/layers.hpp"
#include "ui/style/keys.hpp"
#include "ui/style/theme.hpp"

#include <glm/glm.hpp>
#include <imgui/imgui.h>

#include <algorithm>

namespace zeroset::ui {
namespace {

constexpr float point_reach_em = 0.75F;

/// The points of the picture that can be taken: those that nothing hides.
std::vector<ShownPoint> open_points(const UiState& state, const ViewFrame& view) {
    std::vector<ShownPoint> points = state.shown.points;
    std::erase_if(points, [&](const ShownPoint& point) {
        return is_behind(*state.shown.picture.frame, view,
                         before_ball(view, point.at, point.radius));
    });
    return points;
}

void follow_drag(UiState& state, const ViewFrame& view, const ViewPoint& cursor) {
    PointDrag& drag = *state.input.point_drag;
    Document& document = state.edited.document;
    // Something else has changed them: undo, or a slider.
    if (sliders_of(drag.point, document) != drag.last) drag.given_up = true;
    // A press alone moves nothing.
    const bool moved = ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > 0.0F;
    if (drag.given_up || !moved) return;
    if (is_pressed_once(ImGuiKey_Escape)) {
        drag.given_up = true;
        return take_over(document, drag.start);
    }
    drag.last = dragged(drag, view, cursor, state.input.viewport_px.y);
    take_over(document, drag.last);
}

/// The point as it is now.
ShownPoint renewed(const UiState& state, ShownPoint point) {
    const auto now = std::ranges::find_if(state.shown.points, [&](const ShownPoint& other) {
        return other.row == point.row && other.sliders == point.sliders;
    });
    return now == state.shown.points.end() ? point : *now;
}

}  // namespace

std::optional<ShownPoint> follow_points(UiState& state, const PictureArea& area,
                                        const ViewPoint& cursor) {
    if (state.shown.picture.frame == nullptr || !(area.height() > 0.0F)) {
        state.input.point_drag.reset();
        return std::nullopt;
    }
    const ViewFrame view(state.shown.picture.camera);
    if (state.input.point_drag) {
        follow_drag(state, view, cursor);
        ShownPoint held = renewed(state, state.input.point_drag->point);
        if (!ImGui::IsItemActive()) state.input.point_drag.reset();
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        return held;
    }
    const bool free =
        ImGui::IsItemHovered() && (!ImGui::IsItemActive() || ImGui::IsItemActivated());
    if (!free || state.shown.points.empty()) return std::nullopt;
    const std::vector<ShownPoint> points = open_points(state, view);
    const ShownPoint* const found =
        point_under(points, view, cursor, static_cast<double>(em(point_reach_em) / area.height()));
    if (found == nullptr) return std::nullopt;
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        state.input.point_drag = grabbed(*found, state.edited.document, view, cursor);
        for (const auto& [name, slider] : state.input.point_drag->start)
            state.edited.playing.erase(name);
    }
    return *found;
}

void draw_held_point(ImDrawList& canvas, const PictureArea& area, const UiState& state,
                     const std::optional<ShownPoint>& point) {
    if (!point || state.shown.picture.frame == nullptr) return;
    const ViewFrame view(state.shown.picture.camera);
    const auto seen = place_in_view(view, point->at);
    if (!seen) return;
    const CardStyle style = card_style(state.edited.theme);
    const ImVec2 at = area.at(seen->place);
    const glm::dvec2 dot(at.x - area.lo.x, at.y - area.lo.y);
    const double pixel = view.pixel_width(static_cast<int>(area.height()), seen->distance);
    const double radius = std::max(point->radius / pixel, 0.3 * style.unit) + 0.25 * style.unit;
    Shapes shapes{Circle{
        .middle = dot, .radius = radius, .color = style.colors.accent, .line = 0.12 * style.unit}};
    if (state.input.point_drag) {
        const double resolution =
            0.1 * view.pixel_width(std::max(state.input.viewport_px.y, 1), seen->distance);
        const std::string name = point->name.empty() ? "" : point->name + "  ";
        append(shapes, tag_shapes(name + coordinates_text(point->at, resolution), dot,
                                  radius + 0.3 * style.unit, {area.hi.x - area.lo.x, area.height()},
                                  style));
    }
    canvas.PushClipRect(area.lo, area.hi, true);
    draw_shapes(canvas, area.lo, shapes);
    canvas.PopClipRect();
}

}  // namespace zeroset::ui
