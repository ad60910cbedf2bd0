#include "ui/picture/axis_gizmo.hpp"

#include "engine/annotate/axes.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/base/translation.hpp"
#include "engine/view/camera.hpp"
#include "ui/actions/view_moves.hpp"
#include "ui/model/steering.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/picture/viewport.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/label.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"

#include <glm/glm.hpp>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace zeroset::ui {
namespace {

constexpr float rim_em = 2.9F;    ///< from the middle to where the balls are
constexpr float ball_em = 0.68F;  ///< radius
constexpr float margin_em = 0.7F;
constexpr float least_for_gizmo_em = 11.0F;

constexpr std::array<const char*, 6> ball_names{
    "+x", "+y", "+z", "\xE2\x88\x92x", "\xE2\x88\x92y", "\xE2\x88\x92z"};

float half_size() { return em(rim_em + ball_em + margin_em); }

ImVec2 middle() { return {ImGui::GetIO().DisplaySize.x - half_size(), half_size()}; }

ImVec2 place_of(const GizmoBall& ball) {
    const glm::vec2 place = gizmo_place(ball);
    return {place.x, place.y};
}

/// The nearest ball under the pointer.
std::optional<GizmoBall> ball_under(const std::array<GizmoBall, 6>& balls, const ImVec2& pointer) {
    std::optional<GizmoBall> found;
    for (const GizmoBall& ball : balls) {
        const ImVec2 at = place_of(ball);
        const float distance =
            glm::distance(glm::vec2(at.x, at.y), glm::vec2(pointer.x, pointer.y));
        if (distance <= em(1.2F * ball_em)) found = ball;
    }
    return found;
}

void draw_letter(ImDrawList& canvas, const GizmoBall& ball, std::uint32_t color) {
    const char* const letter = ball_names[static_cast<std::size_t>(ball.axis)] + 1;
    ImFont* const small = font(FontRole::Small);
    const float size = small->FontSize * ImGui::GetIO().FontGlobalScale;
    const ImVec2 extent = small->CalcTextSizeA(size, FLT_MAX, 0.0F, letter);
    const ImVec2 at = place_of(ball);
    // Letters without ascenders look low in a box of the whole line.
    canvas.AddText(small, size, ImVec2(at.x - 0.5F * extent.x, at.y - 0.56F * extent.y), color,
                   letter);
}

void draw_ball(ImDrawList& canvas, const GizmoBall& ball, bool lit, Theme theme) {
    const bool dark = theme == Theme::Dark;
    const std::uint32_t color =
        (dark ? axes_on_dark : axes_on_light).axes[static_cast<std::size_t>(ball.axis)];
    const std::uint32_t ink = dark ? palette(theme).ground : palette(theme).sky;
    const ImVec2 at = place_of(ball);
    // Farther balls are fainter.
    const double opacity = lit ? 1.0 : 0.8 + 0.2 * ball.nearness;
    if (ball.positive) {
        canvas.AddLine(middle(), at, faded(color, 0.8 * opacity), em(0.14F));
        canvas.AddCircleFilled(at, em(ball_em), faded(color, opacity));
        draw_letter(canvas, ball, ink);
    } else {
        canvas.AddCircleFilled(at, em(ball_em), faded(color, lit ? 0.5 : 0.18));
        canvas.AddCircle(at, em(ball_em), faded(color, 0.75 * opacity), 0, em(0.1F));
        if (lit) draw_letter(canvas, ball, palette(theme).text);
    }
}

void follow_pointer(UiState& state, bool clicked, const std::optional<GizmoBall>& under) {
    const ImGuiIO& io = ImGui::GetIO();
    const float moved = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left];
    const bool dragged = moved >= io.MouseDragThreshold * io.MouseDragThreshold;
    if (ImGui::IsItemActive() && dragged) {
        PointerMotion motion;
        const auto height = static_cast<double>(picture_height(state.edited.layout));
        motion.orbit = {.x = static_cast<double>(io.MouseDelta.x) / height,
                        .y = static_cast<double>(-io.MouseDelta.y) / height};
        state.edited.document.camera =
            steer(*state.edited.document.camera, motion, turn_mode_of(state.edited.document));
    }
    if (clicked && !dragged && under) {
        const glm::dvec3 outward = under->outward();
        looks_from(state, outward) ? look_from_opposite(state) : look_from(state, outward);
    }
}

}  // namespace

std::array<GizmoBall, 6> gizmo_balls(const Camera& camera) {
    const ViewFrame frame(camera);
    std::array<GizmoBall, 6> balls;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        GizmoBall& ball = balls[i];
        ball.axis = static_cast<int>(i % 3);
        ball.positive = i < 3;
        const glm::dvec3 direction = ball.outward();
        ball.at = {glm::dot(direction, frame.right), glm::dot(direction, frame.up)};
        ball.nearness = -glm::dot(direction, frame.forward);
    }
    std::ranges::sort(balls, {}, &GizmoBall::nearness);
    return balls;
}

glm::vec2 gizmo_place(const GizmoBall& ball) {
    const ImVec2 at = middle();
    return glm::vec2(at.x, at.y) + em(rim_em) * glm::vec2(ball.at.x, -ball.at.y);
}

void put_under_pages() {
    ImGui::BringWindowToDisplayBack(ImGui::GetCurrentWindow());
    if (ImGuiWindow* const picture = ImGui::FindWindowByName("##viewport"))
        ImGui::BringWindowToDisplayBack(picture);
}

void draw_axis_gizmo(UiState& state) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width = window.x - side_panel_width(state.edited.layout);
    const float height = picture_height(state.edited.layout);
    if (!state.edited.document.camera || std::min(width, height) < em(least_for_gizmo_em)) return;

    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav |
                                       ImGuiWindowFlags_NoScrollWithMouse |
                                       ImGuiWindowFlags_NoFocusOnAppearing;
    const float half = half_size();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
    ImGui::SetNextWindowPos(ImVec2(window.x - 2.0F * half, 0.0F));
    ImGui::SetNextWindowSize(ImVec2(2.0F * half, 2.0F * half));
    if (ImGui::Begin("##gizmo", nullptr, flags)) {
        if (ImGui::IsWindowAppearing()) put_under_pages();
        const bool clicked = ImGui::InvisibleButton("##axes", ImGui::GetContentRegionAvail());
        const bool hovered = ImGui::IsItemHovered();
        const auto balls = gizmo_balls(*state.edited.document.camera);
        const auto under =
            hovered ? ball_under(balls, ImGui::GetIO().MousePos) : std::optional<GizmoBall>();
        follow_pointer(state, clicked, under);
        if (hovered) follow_wheel(state);
        if (under && !ImGui::IsItemActive())
            draw_tooltip(filled(tr("View from {0}"), {std::string(under->positive ? "+" : "-") +
                                                      static_cast<char>('x' + under->axis)}));
        ImDrawList& canvas = *ImGui::GetWindowDrawList();
        if (hovered || ImGui::IsItemActive()) {
            canvas.AddCircleFilled(middle(), half - em(0.2F),
                                   faded(palette(state.edited.theme).text, 0.08));
        }
        for (const GizmoBall& ball : balls) {
            const bool lit = under && under->axis == ball.axis && under->positive == ball.positive;
            draw_ball(canvas, ball, lit, state.edited.theme);
        }
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace zeroset::ui
