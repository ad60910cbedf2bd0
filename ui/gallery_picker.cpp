#include "ui/gallery_picker.hpp"

#include "ui/fonts.hpp"
#include "ui/label.hpp"
#include "ui/theme.hpp"
#include "ui/ui_state.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset::ui {
namespace {

/// Title over equation; true when it is clicked.
bool draw_entry(const GalleryEntry& entry, const Palette& colors) {
    const float line = ImGui::GetTextLineHeight();
    const float height = 2.0F * line + em(0.7F);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool picked = ImGui::Selectable("##entry", false, 0, ImVec2(0.0F, height));
    const ImVec2 end = ImGui::GetItemRectMax();
    if (ImGui::IsItemHovered() && !entry.about.empty()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(em(26.0F));
        ImGui::TextUnformatted(entry.about.c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }

    const ImFont* small = font(FontRole::SmallFormula);
    const float small_size = small->FontSize * ImGui::GetIO().FontGlobalScale;
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    const float left = at.x + em(0.4F);
    const float top = at.y + em(0.2F);
    canvas.AddText(ImVec2(left, top), colors.text, entry.title.c_str());
    const ImVec4 clip(at.x, at.y, end.x, end.y);
    canvas.AddText(small, small_size, ImVec2(left, top + line + em(0.15F)), colors.quiet,
                   in_one_line(entry.equation).c_str(), nullptr, 0.0F, &clip);
    return picked;
}

}  // namespace

void draw_gallery_picker(UiState& state, float width) {
    const Palette& colors = palette(state.theme);
    // As high as the buttons beside it.
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(ImGui::GetStyle().FramePadding.x,
                               0.5F * (std::ceil(em(2.0F)) - ImGui::GetFontSize())));
    ImGui::SetNextItemWidth(width);
    const float list_width = std::min(em(30.0F), 0.9F * ImGui::GetIO().DisplaySize.x);
    const float list_height = std::min(em(34.0F), 0.7F * ImGui::GetIO().DisplaySize.y);
    ImGui::SetNextWindowSizeConstraints(ImVec2(list_width, 0.0F), ImVec2(list_width, list_height));
    const bool open = ImGui::BeginCombo(
        "##gallery", "Gallery", ImGuiComboFlags_PopupAlignLeft | ImGuiComboFlags_HeightLargest);
    ImGui::PopStyleVar();
    if (!open) return;
    for (std::size_t i = 0; i < state.gallery.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (draw_entry(state.gallery[i], colors)) state.surface = i;
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

}  // namespace zeroset::ui
