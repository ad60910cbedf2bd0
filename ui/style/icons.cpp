#include "ui/style/icons.hpp"

#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

namespace zeroset::ui {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// Draws into a square whose coordinates run from (-1, -1) to (1, 1), y downwards.
class Pen {
public:
    Pen(ImDrawList& canvas, const ImVec2& centre, float size, std::uint32_t color)
        : canvas_(canvas),
          centre_(centre),
          half_(0.5F * size),
          color_(color),
          thickness_(std::max(1.0F, size / 10.0F)) {}

    void lines(std::initializer_list<ImVec2> points, bool closed = false) {
        for (const ImVec2& point : points)
            canvas_.PathLineTo(at(point));
        canvas_.PathStroke(color_, closed ? ImDrawFlags_Closed : ImDrawFlags_None, thickness_);
    }
    void filled(std::initializer_list<ImVec2> points) {
        for (const ImVec2& point : points)
            canvas_.PathLineTo(at(point));
        canvas_.PathFillConvex(color_);
    }
    void arc(ImVec2 centre, float radius, float from_rad, float to_rad) {
        canvas_.PathArcTo(at(centre), radius * half_, from_rad, to_rad, 24);
        canvas_.PathStroke(color_, ImDrawFlags_None, thickness_);
    }
    void dot(ImVec2 centre, float radius) {
        canvas_.AddCircleFilled(at(centre), radius * half_, color_);
    }

private:
    [[nodiscard]] ImVec2 at(const ImVec2& p) const {
        return {centre_.x + p.x * half_, centre_.y + p.y * half_};
    }

    ImDrawList& canvas_;
    ImVec2 centre_;
    float half_;
    std::uint32_t color_;
    float thickness_;
};

void draw_eye(Pen& pen) {
    // The outline is two arcs that meet at the corners of the eye.
    const float half_angle = std::atan2(1.0F, 0.75F);
    pen.arc({0.0F, 0.6F}, 1.12F, -0.5F * pi - half_angle, -0.5F * pi + half_angle);
    pen.arc({0.0F, -0.6F}, 1.12F, 0.5F * pi - half_angle, 0.5F * pi + half_angle);
    pen.dot({0.0F, 0.0F}, 0.32F);
}

void draw_closed_eye(Pen& pen) {
    const float half_angle = std::atan2(1.0F, 0.75F);
    pen.arc({0.0F, -0.6F}, 1.12F, 0.5F * pi - half_angle, 0.5F * pi + half_angle);
    for (const float x : {-0.62F, 0.0F, 0.62F}) {
        const float y = x == 0.0F ? 0.52F : 0.34F;
        pen.lines({{x, y}, {1.25F * x, y + 0.34F}});
    }
}

/// Draws an arrow bent back to the left (side -1) or to the right (side 1).
void draw_turn(Pen& pen, float side) {
    pen.lines({{side * 0.45F, -0.8F}, {side * 0.85F, -0.4F}, {side * 0.45F, 0.0F}});
    pen.lines({{side * 0.85F, -0.4F}, {-side * 0.2F, -0.4F}});
    if (side > 0) {
        pen.arc({-0.2F, 0.15F}, 0.55F, 0.5F * pi, 1.5F * pi);
    } else {
        pen.arc({0.2F, 0.15F}, 0.55F, -0.5F * pi, 0.5F * pi);
    }
    pen.lines({{-side * 0.2F, 0.7F}, {side * 0.35F, 0.7F}});
}

void draw_grip(Pen& pen) {
    for (const float x : {-0.3F, 0.3F}) {
        for (const float y : {-0.6F, 0.0F, 0.6F})
            pen.dot({x, y}, 0.14F);
    }
}

void draw_help(Pen& pen) {
    pen.arc({0.0F, -0.38F}, 0.42F, -pi, 0.35F * pi);
    pen.lines({{0.19F, -0.01F}, {0.0F, 0.15F}, {0.0F, 0.4F}});
    pen.dot({0.0F, 0.78F}, 0.13F);
}

void draw_sign(Pen& pen, Icon icon) {
    switch (icon) {
        case Icon::Plus:
            pen.lines({{-0.75F, 0.0F}, {0.75F, 0.0F}});
            return pen.lines({{0.0F, -0.75F}, {0.0F, 0.75F}});
        case Icon::Cross:
            pen.lines({{-0.55F, -0.55F}, {0.55F, 0.55F}});
            return pen.lines({{-0.55F, 0.55F}, {0.55F, -0.55F}});
        case Icon::Eye: return draw_eye(pen);
        case Icon::ClosedEye: return draw_closed_eye(pen);
        case Icon::Play: return pen.filled({{-0.5F, -0.75F}, {0.75F, 0.0F}, {-0.5F, 0.75F}});
        case Icon::Pause:
            pen.filled({{-0.6F, -0.7F}, {-0.15F, -0.7F}, {-0.15F, 0.7F}, {-0.6F, 0.7F}});
            return pen.filled({{0.15F, -0.7F}, {0.6F, -0.7F}, {0.6F, 0.7F}, {0.15F, 0.7F}});
        case Icon::Grip: return draw_grip(pen);
        case Icon::Undo: return draw_turn(pen, -1.0F);
        case Icon::Redo: return draw_turn(pen, 1.0F);
        case Icon::Menu:
            for (const float y : {-0.55F, 0.0F, 0.55F})
                pen.lines({{-0.75F, y}, {0.75F, y}});
            return;
        case Icon::Fold:
            pen.lines({{0.0F, -0.6F}, {-0.6F, 0.0F}, {0.0F, 0.6F}});
            return pen.lines({{0.65F, -0.6F}, {0.05F, 0.0F}, {0.65F, 0.6F}});
        case Icon::Unfold:
            pen.lines({{0.0F, -0.6F}, {0.6F, 0.0F}, {0.0F, 0.6F}});
            return pen.lines({{-0.65F, -0.6F}, {-0.05F, 0.0F}, {-0.65F, 0.6F}});
        case Icon::More:
            for (const float y : {-0.6F, 0.0F, 0.6F})
                pen.dot({0.0F, y}, 0.16F);
            return;
        case Icon::Down: return pen.lines({{-0.6F, -0.3F}, {0.0F, 0.3F}, {0.6F, -0.3F}});
        case Icon::Up: return pen.lines({{-0.6F, 0.3F}, {0.0F, -0.3F}, {0.6F, 0.3F}});
        case Icon::Help: return draw_help(pen);
        case Icon::Copy:
            pen.lines(
                {{-0.3F, 0.35F}, {-0.75F, 0.35F}, {-0.75F, -0.8F}, {0.3F, -0.8F}, {0.3F, -0.4F}});
            return pen.lines({{-0.3F, -0.4F}, {0.75F, -0.4F}, {0.75F, 0.8F}, {-0.3F, 0.8F}}, true);
        case Icon::Folder:
            return pen.lines({{-0.85F, 0.65F},
                              {-0.85F, -0.6F},
                              {-0.3F, -0.6F},
                              {-0.05F, -0.3F},
                              {0.85F, -0.3F},
                              {0.85F, 0.65F}},
                             true);
    }
}

}  // namespace

void draw_icon(ImDrawList& canvas, Icon icon, const ImVec2& centre, float size,
               std::uint32_t color) {
    Pen pen(canvas, centre, size, color);
    draw_sign(pen, icon);
}

bool icon_button(const char* id, Icon icon, const IconLook& look, const std::string& tooltip) {
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(id, ImVec2(look.size, look.size));
    draw_focus_ring();
    const bool hovered = look.enabled && ImGui::IsItemHovered();
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    const ImVec2 hi(lo.x + look.size, lo.y + look.size);
    if (hovered) {
        const ImGuiCol back =
            ImGui::IsItemActive() ? ImGuiCol_ButtonActive : ImGuiCol_ButtonHovered;
        canvas.AddRectFilled(lo, hi, ImGui::GetColorU32(back), 0.25F * look.size);
    }
    const std::uint32_t bright = hovered ? ImGui::GetColorU32(ImGuiCol_Text) : look.color;
    const std::uint32_t faint = (look.color & 0x00FFFFFFU) | 0x50000000U;
    draw_icon(canvas, icon, ImVec2(0.5F * (lo.x + hi.x), 0.5F * (lo.y + hi.y)), 0.55F * look.size,
              look.enabled ? bright : faint);
    if (!tooltip.empty()) draw_tooltip(tooltip);
    return clicked && look.enabled;
}

}  // namespace zeroset::ui
