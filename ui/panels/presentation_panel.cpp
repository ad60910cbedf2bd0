#include "engine/annotate/shapes.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cstdint>

namespace zeroset::ui {
namespace {

constexpr float widest_em = 30.0F;
/// Largest part of the window's height that the sliders take; more of them scroll.
constexpr float most_of_height = 0.45F;

constexpr ImGuiWindowFlags card_flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                        ImGuiWindowFlags_NoFocusOnAppearing;

/// Draws the sliders on a card in the middle of the picture's lower edge.
void draw_sliders(UiState& state) {
    const auto rows =
        static_cast<float>(presented_sliders(state.edited.document, state.shown.reading).size());
    if (rows == 0.0F) return;
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float margin = std::min(em(0.8F), 0.02F * window.x);
    const float gap = em(0.25F);
    const float wanted =
        rows * (ImGui::GetFrameHeight() + gap) - gap + 2.0F * style.WindowPadding.y;
    const ImVec2 size(std::min(em(widest_em), window.x - 2.0F * margin),
                      std::min(wanted, most_of_height * window.y));
    ImGui::SetNextWindowPos(ImVec2(0.5F * (window.x - size.x), window.y - margin - size.y));
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(em(0.3F), gap));
    if (ImGui::Begin("##presented", nullptr, card_flags))
        draw_presented_rows(state.edited, state.shown.reading);
    ImGui::End();
    ImGui::PopStyleVar();
}

/// Draws a button in the right upper corner, faint but under the pointer.
void draw_leave(UiState& state) {
    if (state.edited.read_only) return;
    const float size = em(1.6F);
    const float margin = em(0.4F);
    ImGui::SetNextWindowPos(ImVec2(ImGui::GetIO().DisplaySize.x - size - margin, margin));
    ImGui::SetNextWindowSize(ImVec2(size, size));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
    constexpr ImGuiWindowFlags flags =
        card_flags | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar;
    if (ImGui::Begin("##leave", nullptr, flags)) {
        const Action& action = action_named("Leave the presentation");
        const std::uint32_t faint = faded(palette(state.edited.theme).quiet, 0.6);
        if (icon_button("##cross", Icon::Cross, {.size = size, .color = faint}, described(action)))
            action.run(state);
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace

void draw_presentation(UiState& state) {
    draw_sliders(state);
    draw_leave(state);
}

}  // namespace zeroset::ui
