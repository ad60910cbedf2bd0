#pragma once

#include <cstdint>
#include <string>

struct ImDrawList;
struct ImVec2;

namespace zeroset::ui {

/// Signs drawn as lines, sharp at every scale.
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

/// The sign in a square of `size` about `centre`, window coordinates.
void draw_icon(ImDrawList& canvas, Icon icon, const ImVec2& centre, float size,
               std::uint32_t color);

/// How an icon button looks.
struct IconLook {
    float size;           ///< of the button, window coordinates
    std::uint32_t color;  ///< of the sign; brighter under the pointer
    bool enabled = true;
};

/// A square button without a frame until the pointer is over it; true when it is clicked.
bool icon_button(const char* id, Icon icon, const IconLook& look, const std::string& tooltip);

}  // namespace zeroset::ui
