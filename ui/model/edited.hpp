#pragma once

#include "document/document.hpp"
#include "document/play.hpp"
#include "engine/base/language.hpp"
#include "ui/model/inspection.hpp"
#include "ui/model/theme.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset::ui {

/// The use of a wheel, or of two fingers on a touchpad, over the picture. Ctrl makes it zoom; Shift
/// makes it pan where it orbits, and orbit where it pans.
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
    bool advanced_open = false;
    bool edges_open = false;  ///< of the clip box, each by itself
    bool handles = true;      ///< in the picture, while the section of the clip box is open
    float letters =
        1.0F;  ///< size of letters, and of all that is measured by them; see letter_sizes
    bool presents = false;  ///< only the picture and sliders are shown, large; not kept
    // New documents begin with these, which are as they were when one of them was switched last.
    bool axes = true;
    bool clip_box = true;
    bool grid = true;
    bool smooth_edges = true;
    bool begins_with_last = false;  ///< the window, with the document used last

    WheelUse wheel = WheelUse::Zoom;
    std::optional<Language> language = {};  ///< of the window's texts; nothing: the desktop's

    bool operator==(const Layout&) const = default;
};

inline bool has_clip_handles(const Layout& layout) {
    return layout.handles && layout.clip_open && !layout.presents;
}

/// Sizes of letters that can be chosen, in parts of the usual size.
inline constexpr std::array<float, 9> letter_sizes{0.75F, 0.85F, 1.0F, 1.15F, 1.3F,
                                                   1.5F,  1.75F, 2.0F, 2.5F};
/// How much larger letters are in a presentation.
inline constexpr float presented_letters = 1.5F;

/// The size of letters that is wanted on the screen.
inline float shown_letters(const Layout& layout) {
    return layout.letters * (layout.presents ? presented_letters : 1.0F);
}

/// Shows what new documents begin with, besides what the document shows.
void show_as_new(Document& document, const Layout& layout);
/// Makes edges as smooth as those of new documents are.
void smooth_as_new(Document& document, const Layout& layout);

/// An empty document as the window begins it.
Document new_document(const Layout& layout);

/// The name of w among the sliders; no parameter is called so.
inline constexpr const char* w_name = "w";

/// Everything the user edits. Panels change it; the owner follows and keeps it.
struct Edited {
    Document document = empty_document();
    std::map<std::string, PlayState> playing;  ///< the sliders that play, by name
    int selected_marker = 0;                   ///< its number; 0: none
    Inspection inspection;
    Layout layout;
    Theme theme = Theme::Dark;
    bool follows_desktop = true;      ///< the theme is the desktop's wish, where there is one
    bool tour_seen = true;            ///< the tour has been ended once, or was left out
    bool full_screen = false;         ///< wanted
    bool full_screen_before = false;  ///< the presentation began
    /// A session for a class: a presentation that cannot be left, of a document that is not changed
    /// but by its sliders.
    bool read_only = false;
};

/// Returns the slider of w or of a parameter; first_slider returns its initial settings.
Slider slider_named(const Document& document, const std::string& name);
Slider first_slider(const std::string& name);
/// Stores the slider in the document; a parameter's slider with its initial settings is removed
/// from it.
void set_slider(Document& document, const std::string& name, const Slider& slider);

}  // namespace zeroset::ui
