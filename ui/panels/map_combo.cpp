#include "engine/annotate/shapes.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/picture/draw_shapes.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <cfloat>
#include <string>

namespace zeroset::ui {
namespace {

void draw_preview(ImDrawList& canvas, const ImVec2& lo, ColorMap map) {
    const float height = ImGui::GetTextLineHeight();
    draw_shapes(canvas, lo, {MapBar{.lo = {0.0, 0.0}, .hi = {em(6.0F), height}, .map = map}});
}

/// Draws a line of the list; true when it was chosen.
bool draw_line(ColorMap map, bool shown) {
    const ImVec2 line = ImGui::GetCursorScreenPos();
    const std::string name(name_of(map));
    const bool chosen = ImGui::Selectable(("##" + name).c_str(), shown);
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    draw_preview(canvas, line, map);
    canvas.AddText(ImVec2(line.x + em(6.8F), line.y), ImGui::GetColorU32(ImGuiCol_Text),
                   name.c_str());
    return chosen;
}

}  // namespace

std::optional<ColorMap> draw_map_combo(const char* id, ColorMap shown, float right) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    ImGui::SetNextItemWidth(right > 0.0F ? -right : -FLT_MIN);
    const bool open = ImGui::BeginCombo(id, "");
    // The preview covers the combo's own field.
    draw_preview(canvas, ImVec2(at.x + padding.x, at.y + padding.y), shown);
    if (!open) return std::nullopt;
    std::optional<ColorMap> chosen;
    for (const ColorMap map : color_maps()) {
        if (draw_line(map, map == shown)) chosen = map;
    }
    ImGui::EndCombo();
    return chosen;
}

}  // namespace zeroset::ui
