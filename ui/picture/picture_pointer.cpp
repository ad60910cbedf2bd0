#include "ui/picture/picture_pointer.hpp"

#include "ui/model/ui_state.hpp"
#include "ui/picture/legend.hpp"
#include "ui/picture/picture_marks.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <optional>

namespace zeroset::ui {
namespace {

constexpr float reach_em = 0.6F;

bool is_drag() {
    const ImGuiIO& io = ImGui::GetIO();
    const float threshold = io.MouseDragThreshold;
    return io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >= threshold * threshold;
}

std::optional<MarkedPicture> marked_picture(const UiState& state) {
    if (state.shown.frame == nullptr) return std::nullopt;
    return MarkedPicture{state.document.markers, *state.shown.frame, state.shown.camera,
                         state.selected_marker};
}

PictureClick click_at(const UiState& state, const glm::dvec2& cursor) {
    PictureClick click{.cursor = cursor};
    click.again = ImGui::GetIO().MouseClickedLastCount[ImGuiMouseButton_Left] > 1;
    const auto height = static_cast<double>(ImGui::GetItemRectSize().y);
    const auto picture = marked_picture(state);
    if (picture && height > 0.0) {
        click.marker = marker_under(*picture, cursor, static_cast<double>(em(reach_em)) / height);
    }
    return click;
}

}  // namespace

void follow_picture_pointer(UiState& state, const glm::dvec2& cursor) {
    const bool held = ImGui::IsItemActive();
    const bool pressed_left = ImGui::IsMouseReleased(ImGuiMouseButton_Left);
    if (ImGui::IsItemDeactivated() && pressed_left && !is_drag()) {
        state.click = click_at(state, cursor);
    }
    state.pointer.reset();
    if (ImGui::IsItemHovered() && !(held && is_drag())) state.pointer = cursor;
}

void draw_picture_marks(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi,
                        const UiState& state) {
    const Palette& colors = palette(state.theme);
    canvas.PushClipRect(lo, hi, true);
    if (const auto picture = marked_picture(state)) {
        draw_markers(canvas, lo, hi, *picture, colors);
    }
    const float margin = em(1.0F);
    draw_corner_legend(canvas, ImVec2(hi.x - margin, hi.y - margin),
                       ImVec2(hi.x - lo.x - 2.0F * margin, hi.y - lo.y - 2.0F * margin),
                       {state.legend ? &*state.legend : nullptr, state.document.mark_undecided,
                        state.picture.counts.coarse > 0},
                       colors);
    canvas.PopClipRect();
}

}  // namespace zeroset::ui
