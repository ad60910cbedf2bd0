#pragma once

#include <cstdint>
#include <string>

struct ImDrawList;
struct ImVec2;

namespace zeroset::ui {

/// Icons drawn as vectors, so that they are sharp at every scale.
enum class Icon : std::uint8_t {
    Plus,
    Cross,
    Eye,
    ClosedEye,
    Play,
    Pause,
    Grip,
    Undo,
    Redo,
    Menu,
    Fold,
    Unfold,
    More,
    Down,
    Up,
    Help,
    Folder,
    Copy,
};

/// Draws the icon in a square of side `size` about `centre`, in window coordinates.
void draw_icon(ImDrawList& canvas, Icon icon, const ImVec2& centre, float size,
               std::uint32_t color);

/// Size and colour of an icon button.
struct IconLook {
    float size;           ///< side of the button in window coordinates
    std::uint32_t color;  ///< colour of the icon; the text colour replaces it under the pointer
    bool enabled = true;
};

/// A square button with a background only under the pointer. Returns true when it is clicked.
bool icon_button(const char* id, Icon icon, const IconLook& look, const std::string& tooltip);

}  // namespace zeroset::ui
