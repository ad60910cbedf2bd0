#pragma once

#include "ui/model/dialog_state.hpp"
#include "ui/model/export_page.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace zeroset::ui {

/// A popup with a field to type into. Keys that come before the field has the keyboard wait for it.
struct TypingPopup {
    bool open = false;
    int frames = 0;             ///< for which it has been drawn
    bool has_keyboard = false;  ///< the field had it in the last frame
};

/// The page on which the gallery is looked through.
struct GalleryPage : TypingPopup {
    std::string search;        ///< words that are looked for
    std::size_t selected = 0;  ///< a line of the gallery
    bool follow = false;       ///< the selection is to be scrolled into sight
};

/// The field in which commands are found by a part of their name.
struct CommandPalette : TypingPopup {
    std::string typed;
    std::size_t selected = 0;  ///< of the lines found
    bool follow = false;       ///< the selection is to be scrolled into sight
    std::size_t found = 0;     ///< lines in the last frame
};

/// The help of formulas and keys.
struct HelpPage {
    bool open = false;
    std::string filter;  ///< words that are looked for
};

/// The tour that a new user is shown, step by step, on the window itself.
struct Tour {
    std::optional<std::size_t> step;  ///< that is shown; nothing: no tour
};

/// The field into which a point is typed, in the section of markers.
struct PointField {
    std::string typed;
    bool wrong = false;  ///< it was no point when Enter was pressed
};

/// The pages that open over everything, and texts that are being typed elsewhere.
struct Pages {
    Tour tour;
    GalleryPage gallery;
    CommandPalette commands;
    HelpPage help;
    ExportPage exports;
    Dialogs dialogs;
    PointField point;
};

}  // namespace zeroset::ui
