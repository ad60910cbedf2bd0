#pragma once

#include "ui/model/edited.hpp"
#include "ui/model/input.hpp"
#include "ui/model/pages.hpp"
#include "ui/model/shown.hpp"
#include "ui/model/wishes.hpp"

namespace zeroset::ui {

/// Everything the panels show and edit. Plain data, used by the window's thread only.
struct UiState {
    Edited edited;  ///< changed by panels and owner
    Wishes wishes;  ///< go from the panels to the owner
    Shown shown;    ///< goes from the owner to the panels
    Input input;    ///< tells where pointer and keyboard are
    Pages pages;    ///< open over everything
};

}  // namespace zeroset::ui
