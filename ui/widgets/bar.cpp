#include "ui/widgets/bar.hpp"

#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

namespace zeroset::ui {

bool begin_bar(const char* name, const Palette& colors, int flags) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colors.bar);
    const bool open = ImGui::Begin(name, nullptr,
                                   flags | ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    return open;
}

void end_bar(Edge hairline, const Palette& colors) {
    const ImVec2 lo = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    const float thick = em(1.0F / 14.0F);
    const float y = hairline == Edge::Top ? lo.y : lo.y + size.y - thick;
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    canvas.PushClipRectFullScreen();
    canvas.AddRectFilled(ImVec2(lo.x, y), ImVec2(lo.x + size.x, y + thick), colors.border);
    canvas.PopClipRect();
    ImGui::End();
}

}  // namespace zeroset::ui
