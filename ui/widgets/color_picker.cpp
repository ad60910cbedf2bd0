#include "ui/widgets/color_picker.hpp"

#include "document/colors.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/look_names.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
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

/// Draws the list of what the surface looks as if it were made of.
void draw_look(Statement& statement) {
    const char* const as_all = tr("as all");
    const char* const chosen = statement.look ? shown_name(*statement.look) : as_all;
    const std::string shown = filled(tr("Look: {0}"), {chosen});
    ImGui::SetNextItemWidth(popup_width());
    const bool open = ImGui::BeginCombo("##look", shown.c_str(), ImGuiComboFlags_HeightLarge);
    if (!open) draw_tooltip(tr("What the surface looks as if it were made of"));
    if (!open) return;
    if (ImGui::Selectable(as_all, !statement.look)) statement.look.reset();
    for (const Look look : looks()) {
        if (ImGui::Selectable(shown_name(look), statement.look == look)) statement.look = look;
    }
    ImGui::EndCombo();
}

/// Draws the slider of the surface's opacity. As long as it is not moved the look decides.
void draw_opacity(Statement& statement) {
    double percent = 100.0 * statement.opacity.value_or(1.0);
    const std::string number = statement.opacity ? "%.0f %%" : tr("auto");
    const std::string format = filled(tr("Opacity: {0}"), {number});
    ImGui::SetNextItemWidth(popup_width());
    if (slide("##opacity", percent, 0.0, 100.0, format.c_str(), ImGuiSliderFlags_AlwaysClamp))
        statement.opacity = 0.01 * std::round(percent);
    draw_tooltip(
        tr("How much of what is behind the surface it hides; a right click leaves it to the look"));
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) statement.opacity.reset();
}

/// A button of a choice; true when it is pressed.
bool choice_button(const char* name, bool chosen, float width, const Palette& colors) {
    if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, colors.selection);
    const bool pressed = ImGui::Button(name, ImVec2(width, 0.0F));
    if (chosen) ImGui::PopStyleColor();
    return pressed;
}

/// Draws the field of how wide a curve or a point is, and whether that is in pixels. As long as it
/// is empty the clip box decides.
void draw_thickness(Statement& statement, const Box& clip, const Palette& colors) {
    constexpr double first_pixels = 4.0;
    constexpr double usual_part = 0.012;  // of the clip box
    ImGui::TextDisabled("%s", tr("Thickness"));
    draw_tooltip(
        tr("How wide the curve or point is drawn; an empty field leaves it to the clip "
           "box"));
    const float gap = em(0.3F);
    const float width = (popup_width() - 2.0F * gap) / 3.0F;
    const bool in_pixels = statement.thickness && statement.thickness->in_pixels;
    double number = statement.thickness ? statement.thickness->width : 0.0;
    const double most = in_pixels ? most_pixels_thick : largest_number;
    ImGui::SetNextItemWidth(width);
    if (draw_number_field("##thickness", number, 0.0, most, tr_in("thickness", "auto"))) {
        statement.thickness = Thickness{.width = number, .in_pixels = in_pixels};
        if (!(number > 0.0)) statement.thickness.reset();
    }
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(em(0.2F), ImGui::GetStyle().FramePadding.y));
    ImGui::SameLine(0.0F, gap);
    const bool in_units = statement.thickness && !in_pixels;
    if (choice_button(tr("units"), in_units, width, colors) && !in_units)
        statement.thickness = Thickness{.width = usual_part * clip.size(), .in_pixels = false};
    ImGui::SameLine(0.0F, gap);
    if (choice_button(tr("pixels"), in_pixels, width, colors) && !in_pixels)
        statement.thickness = Thickness{.width = first_pixels, .in_pixels = true};
    ImGui::PopStyleVar();
}

/// Draws the switch of a clip box of the row's own, and its ends.
void draw_box_choice(Statement& statement, const Box& clip) {
    constexpr double farthest = 1e9;
    bool has_own = statement.box.has_value();
    if (ImGui::Checkbox(tr("A clip box of its own"), &has_own))
        statement.box = has_own ? std::optional(clip) : std::nullopt;
    draw_tooltip(tr("Shows only what of this row is in the box, within the clip box of all"));
    if (!statement.box) return;
    Box& box = *statement.box;
    const float gap = em(0.3F);
    const float letter = em(1.0F);
    const float width = 0.5F * (popup_width() - letter - 2.0F * gap);
    for (int axis = 0; axis < 3; ++axis) {
        ImGui::PushID(axis);
        ImGui::AlignTextToFramePadding();
        const std::array<char, 2> name{"xyz"[axis], '\0'};
        ImGui::TextUnformatted(name.data());
        ImGui::SameLine(letter + ImGui::GetStyle().WindowPadding.x, gap);
        ImGui::SetNextItemWidth(width);
        double lo = box.lo[axis];
        if (draw_number_field("##from", lo, -farthest, farthest) && lo < box.hi[axis])
            box.lo[axis] = lo;
        ImGui::SameLine(0.0F, gap);
        ImGui::SetNextItemWidth(width);
        double hi = box.hi[axis];
        if (draw_number_field("##to", hi, -farthest, farthest) && hi > box.lo[axis])
            box.hi[axis] = hi;
        ImGui::PopID();
    }
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

void draw_surface_popup(const char* id, Statement& statement, const SurfaceKind& kind,
                        const Palette& colors) {
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
    draw_look(statement);
    draw_opacity(statement);
    draw_box_choice(statement, kind.clip);
    if (kind.is_thick) draw_thickness(statement, kind.clip, colors);
    if (!kind.is_thick) draw_solid_choice(statement, colors);
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
