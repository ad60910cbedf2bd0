#include "ui/widgets/scroll_fade.hpp"

#include "ui/style/theme.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

namespace zeroset::ui {
namespace {

constexpr float fade_em = 2.0F;
constexpr float covered_em = 0.7F;  ///< at the edge, where nothing is seen

/// Draws from `inner` to `edge`, where all is covered.
void draw_edge(ImDrawList& canvas, const ImRect& inside, float edge, float inwards,
               std::uint32_t back) {
    const std::uint32_t clear = back & ~IM_COL32_A_MASK;
    const float covered = edge + inwards * em(covered_em);
    const float end = edge + inwards * em(fade_em);
    canvas.AddRectFilled(ImVec2(inside.Min.x, edge), ImVec2(inside.Max.x, covered), back);
    canvas.AddRectFilledMultiColor(ImVec2(inside.Min.x, covered), ImVec2(inside.Max.x, end), back,
                                   back, clear, clear);
}

}  // namespace

void draw_scroll_fade(std::uint32_t back) {
    ImGuiWindow& window = *ImGui::GetCurrentWindow();
    const bool above = window.Scroll.y > 0.0F;
    const bool below = window.Scroll.y < window.ScrollMax.y;
    if (!above && !below) return;
    const ImRect inside = window.InnerRect;
    const ImVec2 before = ImGui::GetCursorPos();
    const ImVec2 extent = window.DC.CursorMaxPos;
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                       ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav;
    // A window of its own is drawn over the other ones in this window.
    ImGui::SetCursorScreenPos(inside.Min);
    if (ImGui::BeginChild("##fade", inside.GetSize(), false, flags)) {
        ImDrawList& canvas = *ImGui::GetWindowDrawList();
        if (above) draw_edge(canvas, inside, inside.Min.y, 1.0F, back);
        if (below) draw_edge(canvas, inside, inside.Max.y, -1.0F, back);
    }
    ImGui::EndChild();
    ImGui::SetCursorPos(before);
    window.DC.CursorMaxPos = extent;  // it is no content
}

}  // namespace zeroset::ui
