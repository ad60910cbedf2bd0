#pragma once

#include "document/document.hpp"
#include "document/play.hpp"
#include "ui/model/theme.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset::ui {

/// What a wheel, or two fingers on a touchpad, do over the picture. Those that it is not do so with
/// Ctrl (zoom) or Shift (the other one).
enum class WheelUse : std::uint8_t { Zoom, Orbit, Pan };
std::string_view name_of(WheelUse use);
std::optional<WheelUse> wheel_use_named(std::string_view name);

/// How the window is laid out.
struct Layout {
    float panel_em = 27.0F;  ///< width of the left panel, as far as the window has room
    bool folded = false;
    bool view_open = true;  ///< the section of the view's settings
    bool camera_open = false;
    bool look_open = false;
    bool light_open = false;
    bool markers_open = false;
    bool space_open = false;
    bool clip_open = false;
    bool details_open = false;
    bool edges_open = false;  ///< of the clip box, each by itself
    bool handles = true;      ///< in the picture, while the section of the clip box is open

    WheelUse wheel = WheelUse::Zoom;

    bool operator==(const Layout&) const = default;
};

inline bool has_clip_handles(const Layout& layout) { return layout.handles && layout.clip_open; }

/// The name of w among the sliders; no parameter is called so.
inline constexpr const char* w_name = "w";

/// Everything the user edits. Panels change it; the owner follows and keeps it.
struct Edited {
    Document document = empty_document();
    std::map<std::string, PlayState> playing;  ///< the sliders that play, by name
    int selected_marker = 0;                   ///< its number; 0: none
    Layout layout;
    Theme theme = Theme::Dark;
    bool follows_desktop = true;  ///< the theme is the desktop's wish, where there is one
    bool tour_seen = true;        ///< the tour has been ended once, or was left out
};

}  // namespace zeroset::ui
