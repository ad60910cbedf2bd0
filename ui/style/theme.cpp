#include "ui/style/theme.hpp"

#include "ui/model/theme.hpp"
#include "ui/style/fonts.hpp"

#include <imgui/imgui.h>

#include <cstdint>

namespace zeroset::ui {
namespace {

/// Converts a colour from 0xRRGGBBAA, the usual notation, to the byte order of Palette.
constexpr std::uint32_t rgba(std::uint32_t color) {
    return (color >> 24U) | ((color >> 8U) & 0xFF00U) | ((color << 8U) & 0xFF0000U) |
           (color << 24U);
}

constexpr Palette dark{
    .sky = rgba(0x262B36FF),
    .ground = rgba(0x12151BFF),
    .bar = rgba(0x181C24FF),
    .card = rgba(0x181C24EB),
    .popup = rgba(0x1E232DFA),
    .border = rgba(0xFFFFFF17),
    .field = rgba(0x272D39FF),
    .field_hovered = rgba(0x2F3644FF),
    .field_active = rgba(0x364052FF),
    .row_field = rgba(0x1F242EFF),
    .row_hovered = rgba(0x222833FF),
    .row_active = rgba(0x222A38FF),
    .text = rgba(0xE8EBF1FF),
    .quiet = rgba(0x97A1B3FF),
    .accent = rgba(0x6FA8F5FF),
    .grab = rgba(0x6FA8F5A0),
    .selection = rgba(0x3E6CB0B0),
    .warning = rgba(0xEBC06DFF),
    .error = rgba(0xFF8B86FF),
    .undecided = rgba(0xE0218AFF),
    .undecided_pale = rgba(0xFFE3F2FF),
    .coarse = rgba(0x1E9AA0FF),
};

constexpr Palette light{
    .sky = rgba(0xFBFCFDFF),
    .ground = rgba(0xDCE2EAFF),
    .bar = rgba(0xFFFFFFFF),
    .card = rgba(0xFFFFFFF0),
    .popup = rgba(0xFFFFFFFC),
    .border = rgba(0x1B2A4226),
    .field = rgba(0xEEF1F5FF),
    .field_hovered = rgba(0xE5EAF1FF),
    .field_active = rgba(0xDAE4F3FF),
    .row_field = rgba(0xF6F8FAFF),
    .row_hovered = rgba(0xF1F4F8FF),
    .row_active = rgba(0xE9F0FBFF),
    .text = rgba(0x1C2430FF),
    .quiet = rgba(0x465164FF),
    .accent = rgba(0x2B6BD6FF),
    .grab = rgba(0x2B6BD690),
    .selection = rgba(0x9CC3FAC0),
    .warning = rgba(0x8F5B00FF),
    .error = rgba(0xC42B33FF),
    .undecided = rgba(0xC9106FFF),
    .undecided_pale = rgba(0xFFDCEEFF),
    .coarse = rgba(0x1E9AA0FF),
};

void set_shape(ImGuiStyle& style) {
    style.WindowPadding = ImVec2(14.0F, 12.0F);
    style.FramePadding = ImVec2(10.0F, 6.0F);
    style.ItemSpacing = ImVec2(10.0F, 8.0F);
    style.ItemInnerSpacing = ImVec2(8.0F, 6.0F);
    style.CellPadding = ImVec2(4.0F, 3.0F);
    style.ScrollbarSize = 11.0F;
    style.GrabMinSize = 12.0F;
    style.WindowRounding = 10.0F;
    style.ChildRounding = 8.0F;
    style.PopupRounding = 8.0F;
    style.FrameRounding = 6.0F;
    style.GrabRounding = 5.0F;
    style.ScrollbarRounding = 6.0F;
    style.WindowBorderSize = 1.0F;
    style.PopupBorderSize = 1.0F;
    style.FrameBorderSize = 0.0F;
    style.SelectableTextAlign = ImVec2(0.0F, 0.5F);
}

void set_colors(ImGuiStyle& style, const Palette& colors) {
    const auto set = [&style](ImGuiCol item, std::uint32_t color) {
        style.Colors[item] = ImGui::ColorConvertU32ToFloat4(color);
    };
    set(ImGuiCol_Text, colors.text);
    set(ImGuiCol_TextDisabled, colors.quiet);
    set(ImGuiCol_TextSelectedBg, colors.selection);
    set(ImGuiCol_WindowBg, colors.card);
    set(ImGuiCol_PopupBg, colors.popup);
    set(ImGuiCol_Border, colors.border);
    set(ImGuiCol_FrameBg, colors.field);
    set(ImGuiCol_FrameBgHovered, colors.field_hovered);
    set(ImGuiCol_FrameBgActive, colors.field_active);
    set(ImGuiCol_Button, colors.field);
    set(ImGuiCol_ButtonHovered, colors.field_hovered);
    set(ImGuiCol_ButtonActive, colors.field_active);
    set(ImGuiCol_Header, colors.field_active);
    set(ImGuiCol_HeaderHovered, colors.field_hovered);
    set(ImGuiCol_HeaderActive, colors.field_active);
    set(ImGuiCol_SliderGrab, colors.grab);
    set(ImGuiCol_SliderGrabActive, colors.accent);
    set(ImGuiCol_Separator, colors.border);
    set(ImGuiCol_TableBorderLight, colors.border);
    set(ImGuiCol_TableBorderStrong, colors.border);
    set(ImGuiCol_TitleBg, colors.bar);
    set(ImGuiCol_TitleBgActive, colors.bar);
    set(ImGuiCol_Tab, 0);
    set(ImGuiCol_TabHovered, colors.field_hovered);
    set(ImGuiCol_TabActive, colors.field_active);
    set(ImGuiCol_TabUnfocused, 0);
    set(ImGuiCol_TabUnfocusedActive, colors.field_active);
    set(ImGuiCol_ResizeGrip, colors.field_active);
    set(ImGuiCol_ResizeGripHovered, colors.quiet);
    set(ImGuiCol_ResizeGripActive, colors.accent);
    set(ImGuiCol_ScrollbarBg, 0);
    set(ImGuiCol_ScrollbarGrab, colors.field_active);
    set(ImGuiCol_ScrollbarGrabHovered, colors.quiet);
    set(ImGuiCol_ScrollbarGrabActive, colors.quiet);
    set(ImGuiCol_NavHighlight, colors.accent);
    set(ImGuiCol_ModalWindowDimBg, rgba(0x00000060));
}

}  // namespace

const Palette& palette(Theme theme) { return theme == Theme::Dark ? dark : light; }

Background picture_background(Theme theme) {
    // Palettes have red in the lowest byte, backgrounds blue.
    const auto turned = [](std::uint32_t color) {
        return (color & 0xFFU) << 16U | (color & 0xFF00U) | (color >> 16U & 0xFFU);
    };
    return {.top = turned(palette(theme).sky), .bottom = turned(palette(theme).ground)};
}

void apply_theme(Theme theme, float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    if (theme == Theme::Dark) {
        ImGui::StyleColorsDark(&style);
    } else {
        ImGui::StyleColorsLight(&style);
    }
    set_shape(style);
    set_colors(style, palette(theme));
    style.ScaleAllSizes(scale);
}

float em(float count) {
    return count * font(FontRole::Text)->FontSize * ImGui::GetIO().FontGlobalScale;
}

}  // namespace zeroset::ui
