#include "ui/widgets/color_picker.hpp"

#include "document/colors.hpp"
#include "engine/base/translation.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/typed_slider.hpp"

#include <imgui/imgui.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr int in_a_row = 4;

float swatch() { return em(2.0F); }
float swatch_gap() { return em(0.4F); }
float popup_width() { return in_a_row * swatch() + (in_a_row - 1) * swatch_gap(); }

/// Converts 0xRRGGBB to ImGui's 0xAABBGGRR with full opacity.
std::uint32_t opaque(std::uint32_t rgb) {
    return 0xFF000000U | (rgb & 0xFFU) << 16U | (rgb & 0xFF00U) | (rgb >> 16U & 0xFFU);
}

std::array<float, 3> parts_of(std::uint32_t rgb) {
    const auto part = [rgb](unsigned shift) {
        return static_cast<float>(rgb >> shift & 0xFFU) / 255.0F;
    };
    return {part(16), part(8), part(0)};
}

std::uint32_t color_of(const std::array<float, 3>& parts) {
    std::uint32_t rgb = 0;
    for (const float part : parts)
        rgb = rgb << 8U | static_cast<std::uint32_t>(std::lround(part * 255.0F));
    return rgb;
}

void draw_palette(Statement& statement, const Palette& colors) {
    const std::vector<std::uint32_t>& fronts = palette_fronts();
    const float size = swatch();
    for (std::size_t i = 0; i < fronts.size(); ++i) {
        if (i % in_a_row != 0) ImGui::SameLine(0.0F, swatch_gap());
        ImGui::PushID(static_cast<int>(i));
        const ImVec2 lo = ImGui::GetCursorScreenPos();
        if (ImGui::InvisibleButton("##front", ImVec2(size, size))) statement.color = fronts[i];
        draw_focus_ring();
        const ImVec2 hi(lo.x + size, lo.y + size);
        ImDrawList& canvas = *ImGui::GetWindowDrawList();
        canvas.AddRectFilled(lo, hi, opaque(fronts[i]), em(0.4F));
        const bool marked = statement.color == fronts[i] || ImGui::IsItemHovered();
        canvas.AddRect(lo, hi, marked ? colors.text : colors.border, em(0.4F), 0,
                       em(marked ? 0.15F : 0.07F));
        ImGui::PopID();
    }
}

/// Draws the choice of the side that sections fill, as three buttons.
void draw_solid_choice(Statement& statement, const Palette& colors) {
    ImGui::TextDisabled("%s", tr("Solid"));
    draw_tooltip(tr("The side that sections fill"));
    constexpr std::array<std::pair<const char*, SolidSide>, 3> choices{
        {{marked("auto"), SolidSide::Automatic},
         {"f < 0", SolidSide::Below},
         {"f > 0", SolidSide::Above}}};
    const float gap = em(0.3F);
    const float width = (popup_width() - 2.0F * gap) / 3.0F;
    const ImVec2 padding(em(0.2F), ImGui::GetStyle().FramePadding.y);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
    for (const auto& [name, side] : choices) {
        if (side != choices.front().second) ImGui::SameLine(0.0F, gap);
        const bool chosen = statement.solid == side;
        if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, colors.selection);
        if (ImGui::Button(tr(name), ImVec2(width, 0.0F))) statement.solid = side;
        if (chosen) ImGui::PopStyleColor();
    }
    ImGui::PopStyleVar();
}

/// Draws the slider of the surface's opacity. As long as it is not moved the look decides.
void draw_opacity(Statement& statement) {
    ImGui::TextDisabled("%s", tr("Opacity"));
    draw_tooltip(
        tr("How much of what is behind the surface it hides; a right click leaves it to the look"));
    double percent = 100.0 * statement.opacity.value_or(1.0);
    ImGui::SetNextItemWidth(popup_width());
    const char* const format = statement.opacity ? "%.0f %%" : tr("as the look has it");
    if (slide("##opacity", percent, 0.0, 100.0, format, ImGuiSliderFlags_AlwaysClamp))
        statement.opacity = 0.01 * std::round(percent);
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) statement.opacity.reset();
}

/// Covers the lower right of a dot with the color of the surface's other side.
void draw_back_side(ImDrawList& canvas, const ImVec2& centre, float radius, std::uint32_t front) {
    constexpr float quarter = 0.25F * std::numbers::pi_v<float>;
    const std::uint32_t back = opaque(back_color(front));
    canvas.PathArcTo(centre, radius, -quarter, 3.0F * quarter, 16);
    canvas.PathFillConvex(back);
}

}  // namespace

void draw_color_dot(ImDrawList& canvas, const ImVec2& centre, float radius,
                    const Statement& statement, const Palette& colors, bool hovered) {
    const std::uint32_t color = statement.color ? opaque(*statement.color) : colors.quiet;
    if (statement.visible) {
        canvas.AddCircleFilled(centre, radius, color, 32);
        if (statement.color) draw_back_side(canvas, centre, radius, *statement.color);
        canvas.AddCircle(centre, radius, colors.border, 32, em(0.07F));
    } else {
        canvas.AddCircle(centre, 0.85F * radius, color, 32, 0.3F * radius);
    }
    if (hovered) canvas.AddCircle(centre, radius + em(0.14F), colors.quiet, 32, em(0.1F));
}

void draw_surface_popup(const char* id, Statement& statement, const Palette& colors) {
    if (!ImGui::BeginPopup(id)) return;
    draw_palette(statement, colors);
    ImGui::Dummy(ImVec2(0.0F, em(0.1F)));
    std::array<float, 3> parts = parts_of(statement.color.value_or(palette_fronts().front()));
    constexpr ImGuiColorEditFlags flags = ImGuiColorEditFlags_NoSidePreview |
                                          ImGuiColorEditFlags_NoInputs |
                                          ImGuiColorEditFlags_NoAlpha | ImGuiColorEditFlags_NoLabel;
    ImGui::SetNextItemWidth(popup_width());
    if (ImGui::ColorPicker3("##any", parts.data(), flags)) statement.color = color_of(parts);
    ImGui::Dummy(ImVec2(0.0F, em(0.1F)));
    draw_opacity(statement);
    draw_solid_choice(statement, colors);
    ImGui::EndPopup();
}

bool draw_color_field(const char* id, std::uint32_t& color, const char* about) {
    std::array<float, 3> parts = parts_of(color);
    constexpr ImGuiColorEditFlags flags =
        ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoTooltip |
        ImGuiColorEditFlags_PickerHueWheel;
    const bool picked = ImGui::ColorEdit3(id, parts.data(), flags);
    draw_tooltip(about);
    if (picked) color = color_of(parts);
    return picked;
}

}  // namespace zeroset::ui
