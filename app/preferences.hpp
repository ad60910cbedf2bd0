#pragma once

#include "ui/ui_state.hpp"
#include "ui/window.hpp"

#include <filesystem>
#include <optional>

namespace zeroset {

/// What a window takes over from the one before it.
struct Preferences {
    ui::Layout layout;
    std::optional<ui::Theme> theme;          ///< nothing: that of the desktop
    ui::Theme last_theme = ui::Theme::Dark;  ///< until the desktop has answered
    ui::WindowSize window;
    bool operator==(const Preferences&) const = default;
};

/// From the folder's file; what is missing or makes no sense is as usual.
Preferences load_preferences(const std::filesystem::path& folder);

/// Makes the folder where it is missing. What cannot be written is left: the program works as well.
void save_preferences(const std::filesystem::path& folder, const Preferences& preferences);

}  // namespace zeroset
