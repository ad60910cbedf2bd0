#include "ui/picture/viewport.hpp"

#include "engine/annotate/hidden.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/view/camera.hpp"
#include "engine/view/navigation.hpp"
#include "ui/actions/view_moves.hpp"
#include "ui/model/steering.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/picture/layers.hpp"
#include "ui/picture/picture_marks.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/texture.hpp"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_int2.hpp>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

namespace zeroset::ui {
namespace {

/// How much of a picture of another text the background hides.
constexpr double dimmest = 0.6;

glm::ivec2 size_px(const PictureArea& area) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    return {static_cast<int>(std::lround((area.hi.x - area.lo.x) * scale.x)),
            static_cast<int>(std::lround(area.height() * scale.y))};
}

double aspect_of(const PictureArea& area) {
    return static_cast<double>((area.hi.x - area.lo.x) / area.height());
}

void draw_picture(const PictureArea& area, const UiState& state, const Texture& picture) {
    const Palette& colors = palette(state.edited.theme);
    ImDrawList& canvas = *ImGui::GetBackgroundDrawList();
    canvas.AddRectFilledMultiColor(area.lo, area.hi, colors.sky, colors.sky, colors.ground,
                                   colors.ground);
    if (picture.width() == 0) return;
    const bool exact = picture.width() == state.input.viewport_px.x &&
                       picture.height() == state.input.viewport_px.y;
    picture.set_filter(exact ? Filter::Nearest : Filter::Linear);
    const auto id = static_cast<std::uintptr_t>(picture.name());
    // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui keeps OpenGL's number as a pointer
    canvas.AddImage(reinterpret_cast<ImTextureID>(id), area.lo, area.hi);
    if (state.shown.picture.dimmed > 0.0F) {
        const double veil = dimmest * static_cast<double>(state.shown.picture.dimmed);
        const std::uint32_t sky = faded(colors.sky, veil);
        const std::uint32_t ground = faded(colors.ground, veil);
        canvas.AddRectFilledMultiColor(area.lo, area.hi, sky, sky, ground, ground);
    }
    draw_other_picture(canvas, area, state);
    draw_axes(canvas, area.lo, area.hi, state.edited, state.shown.picture);
    draw_picture_marks(canvas, area.lo, area.hi, state.edited, state.shown);
}

PointerMotion pointer_motion(const PictureArea& area) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto height = static_cast<double>(area.height());
    const ViewShift moved{.x = static_cast<double>(io.MouseDelta.x) / height,
                          .y = static_cast<double>(-io.MouseDelta.y) / height};

    PointerMotion motion;
    // The move up to the press is no drag.
    if (ImGui::IsItemActive() && !ImGui::IsItemActivated()) {
        const bool pans = !ImGui::IsMouseDown(ImGuiMouseButton_Left) || io.KeyShift;
        (pans ? motion.pan : motion.orbit) = moved;
    }
    motion.cursor = area.place(io.MousePos);
    motion.aspect = aspect_of(area);
    return motion;
}

/// Right after the item that the picture is.
void follow_view_pointer(UiState& state, const PointerMotion& motion) {
    if (!state.edited.document.camera) return;
    state.edited.document.camera =
        steer(*state.edited.document.camera, motion, turn_mode_of(state.edited.document));
    if (!ImGui::IsItemHovered() || !ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return;
    const auto point = surface_under(state.shown.picture, motion.cursor);
    if (point) centre_on(state, *point);
}

/// Right after the item that the picture is: gives the pointer to a handle, or to the view.
void follow_pointer(UiState& state, const PictureArea& area) {
    const PointerMotion motion = pointer_motion(area);
    const std::optional<Handle> handle = follow_clip_handles(state, area, motion.cursor);
    const std::optional<ShownPoint> point =
        handle ? std::nullopt : follow_points(state, area, motion.cursor);
    const bool drags = state.input.handle_drag || state.input.point_drag;
    if (ImGui::IsItemHovered() && !drags) follow_wheel(state);
    if (handle || point) {
        state.input.pointer.reset();
    } else {
        follow_picture_pointer(state, motion.cursor);
        follow_view_pointer(state, motion);
    }
    draw_clip_handles(*ImGui::GetBackgroundDrawList(), area, state, handle);
    draw_held_point(*ImGui::GetBackgroundDrawList(), area, state, point);
}

}  // namespace

void follow_wheel(UiState& state) {
    const ImGuiIO& io = ImGui::GetIO();
    Edited& edited = state.edited;
    std::optional<Camera>& camera = edited.document.camera;
    const double pinch = state.input.pinch;
    const bool turned = io.MouseWheel != 0.0F || io.MouseWheelH != 0.0F;
    if ((!turned && pinch == 1.0) || !camera) return;
    PointerMotion motion = scrolled(edited.layout.wheel, static_cast<double>(io.MouseWheelH),
                                    static_cast<double>(io.MouseWheel), io.KeyCtrl, io.KeyShift);
    const PictureArea area = viewport_area(edited.layout);
    motion.cursor = area.place(io.MousePos);
    motion.aspect = aspect_of(area);
    motion.pinch = pinch;
    motion.surface = surface_under(state.shown.picture, motion.cursor);
    camera = steer(*camera, motion, turn_mode_of(edited.document));
}

std::optional<glm::dvec3> surface_under(const ShownPicture& shown, const ViewPoint& cursor) {
    if (shown.frame == nullptr) return std::nullopt;
    const Framebuffer& frame = *shown.frame;
    const glm::ivec2 pixel = pixel_under(frame, cursor);
    const int col = pixel.x;
    const int row = pixel.y;
    if (col < 0 || col >= frame.width || row < 0 || row >= frame.height) return std::nullopt;
    const auto distance = static_cast<double>(frame.depth[frame.index(col, row)]);
    if (!std::isfinite(distance)) return std::nullopt;
    return point_under(shown.camera, cursor, distance);
}

void draw_viewport(UiState& state, const Texture& picture) {
    const PictureArea area = viewport_area(state.edited.layout);
    state.input.viewport_px = size_px(area);
    draw_picture(area, state, picture);
    if (state.input.viewport_px.x <= 0 || state.input.viewport_px.y <= 0) return;

    // A window without looks, behind all others, that takes what the panels do not want.
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav |
                                       ImGuiWindowFlags_NoScrollWithMouse |
                                       ImGuiWindowFlags_NoBringToFrontOnFocus;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
    ImGui::SetNextWindowPos(area.lo);
    ImGui::SetNextWindowSize(ImVec2(area.hi.x - area.lo.x, area.height()));
    if (ImGui::Begin("##viewport", nullptr, flags)) {
        draw_divider(state, area);
        ImGui::InvisibleButton(
            "##picture", ImGui::GetContentRegionAvail(),
            ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
        follow_pointer(state, area);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace zeroset::ui
