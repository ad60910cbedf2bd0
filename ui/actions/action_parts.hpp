#pragma once

#include "engine/base/translation.hpp"
#include "ui/actions/actions.hpp"

#include <span>

// The parts that the table of actions is made of.

namespace zeroset::ui {

std::span<const Action> picture_actions();
std::span<const Action> view_actions();
std::span<const Action> document_actions();
std::span<const Action> window_actions();

/// Sections of the help.
namespace section {
inline constexpr const char* picture = marked("Picture");
inline constexpr const char* view = marked("View");
inline constexpr const char* document = marked("Document");
inline constexpr const char* window = marked("Window");
}  // namespace section

inline void flip(bool& flag) { flag = !flag; }

template <Command command>
void give(UiState& state) {
    state.wishes.command = command;
}

template <bool Document::* flag>
void toggle_document(UiState& state) {
    flip(state.edited.document.*flag);
}

template <bool Document::* flag>
bool is_document(const UiState& state) {
    return state.edited.document.*flag;
}

inline bool has_camera(const UiState& state) { return state.edited.document.camera.has_value(); }

}  // namespace zeroset::ui
