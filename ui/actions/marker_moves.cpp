#include "ui/actions/action_functions.hpp"
#include "ui/actions/view_moves.hpp"

#include <algorithm>

namespace zeroset::ui {

void go_to(UiState& state, const glm::dvec3& point) {
    std::vector<Marker>& markers = state.edited.document.markers;
    const auto there = std::ranges::find(markers, point, &Marker::at);
    const int number = there != markers.end() ? there->number : add_marker(markers, point);
    if (number != 0) state.edited.selected_marker = number;
    state.edited.layout.markers_open = true;
    centre_on(state, point);
}

void ask_for_point(UiState& state) {
    Layout& layout = state.edited.layout;
    layout.folded = false;
    layout.markers_open = true;
    state.wishes.point_field = true;
}

}  // namespace zeroset::ui
