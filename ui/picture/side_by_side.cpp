#include "ui/picture/layers.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace zeroset::ui {
namespace {

constexpr float divider_reach_em = 0.5F;  ///< of the pointer, to both sides of the divider
/// The parts of the width that each picture keeps.
constexpr float least_part = 0.02F;

float divider_x(const PictureArea& area, const Inspection& wanted) {
    return std::round(area.lo.x + wanted.divider * (area.hi.x - area.lo.x));
}

/// A name on a card, whose corner at `at` is the right upper one, or the left upper one.
void draw_name(ImDrawList& canvas, const std::string& name, const ImVec2& at, bool at_right,
               const Palette& colors) {
    const ImVec2 size = ImGui::CalcTextSize(name.c_str());
    const ImVec2 padding(em(0.5F), em(0.25F));
    const float width = size.x + 2.0F * padding.x;
    const ImVec2 lo(std::round(at_right ? at.x - width : at.x), std::round(at.y));
    const ImVec2 hi(lo.x + width, lo.y + size.y + 2.0F * padding.y);
    canvas.AddRectFilled(lo, hi, colors.card, em(0.3F));
    canvas.AddRect(lo, hi, colors.border, em(0.3F));
    canvas.AddText(ImVec2(lo.x + padding.x, lo.y + padding.y), colors.text, name.c_str());
}

}  // namespace

bool has_divider(const UiState& state) {
    const Edited& edited = state.edited;
    return edited.inspection.other && !edited.inspection.difference && !edited.layout.presents;
}

void draw_other_picture(ImDrawList& canvas, const PictureArea& area, const UiState& state) {
    const Inspection& wanted = state.edited.inspection;
    const OtherPicture& other = state.shown.other;
    if (!wanted.other || other.texture == 0 || state.edited.layout.presents) return;
    const float from = wanted.difference ? area.lo.x : divider_x(area, wanted);
    const Palette& colors = palette(state.edited.theme);
    canvas.PushClipRect(ImVec2(from, area.lo.y), area.hi, true);
    canvas.AddRectFilledMultiColor(area.lo, area.hi, colors.sky, colors.sky, colors.ground,
                                   colors.ground);
    // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui keeps OpenGL's number as a pointer
    const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(other.texture));
    canvas.AddImage(texture, area.lo, area.hi);
    canvas.PopClipRect();
}

void draw_divider(UiState& state, const PictureArea& area) {
    if (!has_divider(state)) return;
    Inspection& wanted = state.edited.inspection;
    const float width = area.hi.x - area.lo.x;
    const float reach = em(divider_reach_em);
    const ImVec2 start = ImGui::GetCursorPos();
    ImGui::SetCursorScreenPos(ImVec2(divider_x(area, wanted) - reach, area.lo.y));
    ImGui::InvisibleButton("##divider", ImVec2(2.0F * reach, area.height()));
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive())
        wanted.divider = std::clamp((ImGui::GetIO().MousePos.x - area.lo.x) / width, least_part,
                                    1.0F - least_part);
    ImGui::SetCursorPos(start);

    const Palette& colors = palette(state.edited.theme);
    const float x = divider_x(area, wanted);
    ImDrawList& canvas = *ImGui::GetBackgroundDrawList();
    canvas.PushClipRect(area.lo, area.hi, true);
    canvas.AddLine(ImVec2(x, area.lo.y), ImVec2(x, area.hi.y), lit ? colors.accent : colors.text,
                   em(lit ? 0.2F : 0.1F));
    const float top = area.lo.y + em(0.8F);
    draw_name(canvas, wanted.tracer, ImVec2(x - em(0.8F), top), true, colors);
    const OtherPicture& other = state.shown.other;
    const std::string busy = other.complete ? "" : " \xE2\x80\xA6";
    draw_name(canvas, *wanted.other + busy, ImVec2(x + em(0.8F), top), false, colors);
    canvas.PopClipRect();
}

}  // namespace zeroset::ui
