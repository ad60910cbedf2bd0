#pragma once

#include "ui/model/edited.hpp"

#include <span>

namespace zeroset::ui {

/// A control of the side panel that no action stands for, to be found by its label.
struct PanelControl {
    const char* label;
    const char* section;       ///< its title
    bool Layout::* open;       ///< whether the section is
    const char* words;         ///< as OtherWords::words
    const char* context = "";  ///< of the label, as of tr_in; empty: none
};

/// All of them, section by section.
std::span<const PanelControl> panel_controls();

}  // namespace zeroset::ui
