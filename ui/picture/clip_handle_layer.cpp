#include "engine/annotate/axes.hpp"
#include "engine/annotate/hidden.hpp"
#include "engine/annotate/markers.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/view/pixel_ray.hpp"
#include "ui/picture/clip_outline.hpp"
#include "ui/picture/draw_shapes.hpp"
#include "ui/picture/layers.hpp"
#include "ui/style/keys.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset::ui {
namespace {

constexpr float stem_em = 6.0F;
constexpr double longest_stem = 0.15;  ///< in heights of the picture
constexpr float handle_reach_em = 0.75F;
constexpr float size_em = 0.36F;  ///< half of a square's edge, a ball's radius
constexpr double hidden_part = 0.4;
constexpr double outline_part = 0.85;  ///< opacity of what the pointer's handle moves
constexpr double faint_part = 0.3;     ///< of a ball's outline otherwise

Clipping clipping_of(const Document& document) {
    return {.clip = document.clip, .region = document.region};
}

DragKeys keys_held() { return {.shift = ImGui::GetIO().KeyShift, .ctrl = ImGui::GetIO().KeyCtrl}; }

void take_clipping(Document& document, const Clipping& clipping) {
    document.clip = clipping.clip;
    document.region = clipping.region;
}

void follow_drag(UiState& state, const ViewPoint& cursor) {
    HandleDrag& drag = *state.input.handle_drag;
    // Something else has changed it: undo, or a field.
    if (clipping_of(state.edited.document) != drag.last) drag.given_up = true;
    // A press alone moves nothing.
    const bool moved = ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > 0.0F;
    if (drag.given_up || !moved) return;
    if (is_pressed_once(ImGuiKey_Escape)) {
        drag.given_up = true;
        return take_clipping(state.edited.document, drag.start);
    }
    drag.last = dragged(drag, ViewFrame(state.shown.picture.camera), cursor,
                        state.input.viewport_px.y, keys_held());
    take_clipping(state.edited.document, drag.last);
}

/// Across what moves; GLFW has no cursors for slanted directions.
ImGuiMouseCursor cursor_of(const Handle& handle, const ViewFrame& view) {
    if (handle.along == glm::dvec3(0.0)) return ImGuiMouseCursor_Hand;
    const glm::dvec3 at = view.homogeneous(handle.at);
    const glm::dvec3 step = view.homogeneous(handle.at + handle.along) - at;
    const glm::dvec2 course = glm::dvec2(step) * at.z - glm::dvec2(at) * step.z;
    return std::abs(course.x) > std::abs(course.y) ? ImGuiMouseCursor_ResizeEW
                                                   : ImGuiMouseCursor_ResizeNS;
}

std::uint32_t color_of(const Handle& handle, Theme theme) {
    if (handle.id.part != HandlePart::BoxFace) return palette(theme).accent;
    return (theme == Theme::Dark ? axes_on_dark : axes_on_light).axes[handle.id.index / 2];
}

double opacity_of(std::uint32_t color) { return static_cast<double>(color >> 24U) / 255.0; }

/// White, as opaque as the colour.
std::uint32_t white_on(std::uint32_t color) { return faded(0xFFFFFFFFU, opacity_of(color)); }

struct HandlePen {
    ImDrawList& canvas;
    const PictureArea& area;
    const ViewFrame& view;

    [[nodiscard]] std::optional<ImVec2> place(const glm::dvec3& point) const {
        const auto seen = place_in_view(view, point);
        return seen ? std::optional(area.at(seen->place)) : std::nullopt;
    }
    void outline(const std::vector<glm::dvec3>& corners, std::uint32_t color) const;
    void arrow(const ImVec2& from, const ImVec2& to, std::uint32_t color, float size) const;
    void square(const ImVec2& at, std::uint32_t color, float half) const;
    void ball(const ImVec2& at, std::uint32_t color, float radius) const;
    void handle(const Handle& handle, std::uint32_t color, bool lit) const;
};

/// On any ground: a dark line below a coloured one.
void HandlePen::outline(const std::vector<glm::dvec3>& corners, std::uint32_t color) const {
    std::vector<ImVec2> places;
    for (const glm::dvec3& corner : corners) {
        const auto at = place(corner);
        if (!at) return;  // reaches behind the eye
        places.push_back(*at);
    }
    const int count = static_cast<int>(places.size());
    canvas.AddPolyline(places.data(), count, faded(0xFF000000U, 0.3 * opacity_of(color)),
                       ImDrawFlags_Closed, em(0.22F));
    canvas.AddPolyline(places.data(), count, color, ImDrawFlags_Closed, em(0.11F));
}

void HandlePen::arrow(const ImVec2& from, const ImVec2& to, std::uint32_t color, float size) const {
    const ImVec2 way(to.x - from.x, to.y - from.y);
    const float length = std::hypot(way.x, way.y);
    if (!(length > 0.0F)) return;
    const ImVec2 step(way.x / length * size, way.y / length * size);
    const ImVec2 neck(to.x - 1.1F * step.x, to.y - 1.1F * step.y);
    const ImVec2 tip(to.x + 1.1F * step.x, to.y + 1.1F * step.y);
    const ImVec2 left(neck.x - step.y, neck.y + step.x);
    const ImVec2 right(neck.x + step.y, neck.y - step.x);
    canvas.AddLine(from, neck, faded(0xFF000000U, 0.4), em(0.26F));
    canvas.AddLine(from, neck, color, em(0.14F));
    canvas.AddTriangleFilled(tip, left, right, color);
    canvas.AddTriangle(tip, left, right, faded(0xFF000000U, 0.5), em(0.07F));
}

void HandlePen::square(const ImVec2& at, std::uint32_t color, float half) const {
    const ImVec2 lo(at.x - half, at.y - half);
    const ImVec2 hi(at.x + half, at.y + half);
    canvas.AddRectFilled(lo, hi, color, em(0.12F));
    canvas.AddRect(lo, hi, white_on(color), em(0.12F), 0, em(0.1F));
    const float rim = em(0.07F);
    canvas.AddRect(ImVec2(lo.x - rim, lo.y - rim), ImVec2(hi.x + rim, hi.y + rim),
                   faded(0xFF000000U, 0.5), em(0.16F), 0, rim);
}

void HandlePen::ball(const ImVec2& at, std::uint32_t color, float radius) const {
    canvas.AddCircleFilled(at, radius, color, 24);
    canvas.AddCircle(at, radius, white_on(color), 24, em(0.1F));
    canvas.AddCircle(at, radius + em(0.08F), faded(0xFF000000U, 0.5), 24, em(0.07F));
}

void HandlePen::handle(const Handle& handle, std::uint32_t color, bool lit) const {
    const auto at = place(handle.at);
    const auto from = place(handle.from);
    if (!at || !from) return;
    const float size = em(lit ? 1.3F * size_em : size_em);
    switch (handle.id.part) {
        case HandlePart::BoxFace: return square(*at, color, size);
        case HandlePart::BallCentre: {
            ball(*at, color, size);
            const std::uint32_t ink = white_on(color);
            const float half = 0.6F * size;
            canvas.AddLine(ImVec2(at->x - half, at->y), ImVec2(at->x + half, at->y), ink, em(0.1F));
            canvas.AddLine(ImVec2(at->x, at->y - half), ImVec2(at->x, at->y + half), ink, em(0.1F));
            return;
        }
        case HandlePart::BallRadius: return ball(*at, color, size);
        case HandlePart::SectionPlace: return arrow(*from, *at, color, size);
        case HandlePart::SectionTilt:
            canvas.AddLine(*from, *at, faded(color, 0.6), em(0.09F));
            return ball(*at, color, 0.85F * size);
    }
}

void draw_lit(const HandlePen& pen, const UiState& state, const Handle& handle) {
    const Clipping clipping = clipping_of(state.edited.document);
    const std::uint32_t color = color_of(handle, state.edited.theme);
    pen.outline(outline_of(handle.id, clipping, pen.view), faded(color, outline_part));
    pen.handle(handle, color, true);
    const auto at = pen.place(handle.at);
    if (!at) return;
    const PictureArea& area = pen.area;
    const glm::dvec2 dot(at->x - area.lo.x, at->y - area.lo.y);
    const glm::dvec2 size(area.hi.x - area.lo.x, area.height());
    draw_shapes(
        pen.canvas, area.lo,
        tag_shapes(handle_text(handle, clipping, pen.view, state.input.viewport_px.y), dot,
                   static_cast<double>(em(size_em + 0.5F)), size, card_style(state.edited.theme)));
}

/// Draws the edges of the clip box, so that its handles lie on something, unless they are drawn
/// anyway.
void draw_box(const HandlePen& pen, const UiState& state) {
    if (state.edited.document.clip_box) return;
    const Clipping clipping = clipping_of(state.edited.document);
    const std::uint32_t color = faded(palette(state.edited.theme).quiet, 0.5 * faint_part);
    // Two opposite faces of each axis have all edges; each edge lies on two faces.
    for (const std::size_t face : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}})
        pen.outline(outline_of({.part = HandlePart::BoxFace, .index = face}, clipping, pen.view),
                    color);
}

}  // namespace

std::vector<Handle> shown_handles(const UiState& state, float height) {
    // Without a surface there is nothing to clip.
    if (!has_clip_handles(state.edited.layout) || state.shown.picture.frame == nullptr ||
        state.shown.reading.surface_rows.empty() || !(height > 0.0F))
        return {};
    const Clipping clipping = clipping_of(state.edited.document);
    const double stem = std::min(static_cast<double>(em(stem_em) / height), longest_stem);
    auto handles = clip_handles(clipping, ViewFrame(state.shown.picture.camera), stem);
    if (state.input.handle_drag) hold(handles, *state.input.handle_drag, clipping);
    return handles;
}

std::optional<Handle> follow_clip_handles(UiState& state, const PictureArea& area,
                                          const ViewPoint& cursor) {
    const bool free =
        ImGui::IsItemHovered() && (!ImGui::IsItemActive() || ImGui::IsItemActivated());
    if (!state.input.handle_drag && !free) return std::nullopt;
    const ViewFrame view(state.shown.picture.camera);
    if (state.input.handle_drag) follow_drag(state, cursor);
    const std::vector<Handle> handles = shown_handles(state, area.height());
    std::optional<Handle> found;
    if (state.input.handle_drag) {
        found = state.input.handle_drag->handle;
        const auto now = std::ranges::find(handles, found->id, &Handle::id);
        if (now != handles.end()) found = *now;
        if (!ImGui::IsItemActive()) state.input.handle_drag.reset();
    } else {
        found = handle_under(handles, view, cursor,
                             static_cast<double>(em(handle_reach_em) / area.height()));
        const bool pressed = ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
        if (found && pressed)
            state.input.handle_drag =
                grabbed(*found, clipping_of(state.edited.document), view, cursor);
    }
    if (found) ImGui::SetMouseCursor(cursor_of(*found, view));
    return found;
}

void draw_clip_handles(ImDrawList& canvas, const PictureArea& area, const UiState& state,
                       const std::optional<Handle>& lit) {
    std::vector<Handle> handles = shown_handles(state, area.height());
    if (handles.empty()) return;
    const ViewFrame view(state.shown.picture.camera);
    const HandlePen pen{.canvas = canvas, .area = area, .view = view};
    canvas.PushClipRect(area.lo, area.hi, true);
    draw_box(pen, state);
    // Nearer handles cover farther ones.
    std::ranges::sort(handles, std::ranges::greater(),
                      [&](const Handle& handle) { return view.distance_of(handle.at); });
    for (const Handle& handle : handles) {
        if (lit && lit->id == handle.id) continue;
        const bool hidden = is_behind(*state.shown.picture.frame, view, handle.at);
        const std::uint32_t color = color_of(handle, state.edited.theme);
        if (handle.id.part == HandlePart::BallCentre) {
            pen.outline(outline_of(handle.id, clipping_of(state.edited.document), view),
                        faded(color, faint_part));
        }
        pen.handle(handle, hidden ? faded(color, hidden_part) : color, false);
    }
    if (lit) draw_lit(pen, state, *lit);
    canvas.PopClipRect();
}

}  // namespace zeroset::ui
