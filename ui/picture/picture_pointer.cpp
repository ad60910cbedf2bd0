#include "ui/model/ui_state.hpp"
#include "ui/picture/picture_marks.hpp"
#include "ui/picture/viewport.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

namespace zeroset::ui {
namespace {

constexpr float marker_reach_em = 0.6F;

bool is_drag() {
    const ImGuiIO& io = ImGui::GetIO();
    const float threshold = io.MouseDragThreshold;
    return io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >= threshold * threshold;
}

PictureClick click_at(const UiState& state, const ViewPoint& cursor) {
    PictureClick click{.cursor = cursor};
    click.again = ImGui::GetIO().MouseClickedLastCount[ImGuiMouseButton_Left] > 1;
    const auto height = static_cast<double>(ImGui::GetItemRectSize().y);
    if (height > 0.0)
        click.marker = marker_under(state.edited.document.markers, state.shown.picture, cursor,
                                    static_cast<double>(em(marker_reach_em)) / height);
    return click;
}

}  // namespace

void follow_picture_pointer(UiState& state, const ViewPoint& cursor) {
    const bool held = ImGui::IsItemActive();
    const bool pressed_left = ImGui::IsMouseReleased(ImGuiMouseButton_Left);
    if (ImGui::IsItemDeactivated() && pressed_left && !is_drag()) {
        state.wishes.click = click_at(state, cursor);
    }
    state.input.pointer.reset();
    if (ImGui::IsItemHovered() && !(held && is_drag())) state.input.pointer = cursor;
}

}  // namespace zeroset::ui
