#pragma once

#include "ui/model/edited.hpp"
#include "ui/model/theme.hpp"
#include "ui/window/window.hpp"

#include <filesystem>
#include <optional>
#include <utility>

namespace zeroset {

/// Everything a window takes over from the previous one.
struct Preferences {
    ui::Layout layout;
    std::optional<ui::Theme> theme;          ///< nothing: the desktop's theme
    ui::Theme last_theme = ui::Theme::Dark;  ///< used until the desktop has answered
    ui::WindowSize window;
    bool tour_seen = false;  ///< the window's tour has been ended, or was not wanted
    bool operator==(const Preferences&) const = default;
};

/// Reads the folder's file; a value that is missing or makes no sense becomes the default.
Preferences load_preferences(const std::filesystem::path& folder);

/// Keeps the folder's file up to date. Writes a moment after a change, so that moving a window does
/// not write at every step and a crash loses no more than that moment.
class PreferencesFile {
public:
    static constexpr double rest_s = 1.0;  ///< time without a change before the file is written
    static constexpr double longest_s =
        5.0;  ///< longest time from the first change to writing, even if changes go on

    /// `saved`: the preferences in the file. Without a folder nothing is written.
    PreferencesFile(std::optional<std::filesystem::path> folder, const Preferences& saved)
        : folder_(std::move(folder)), saved_(saved), newest_(saved) {}

    /// Takes the preferences at `now_s` (any clock that does not go back) and writes them when due.
    void follow(const Preferences& now, double now_s);
    /// Seconds until follow() must be called even if no event comes; nothing: not at all.
    [[nodiscard]] std::optional<double> due_s(double now_s) const;
    /// Writes changes that are not written yet.
    void finish();

private:
    [[nodiscard]] double due_at_s() const;

    std::optional<std::filesystem::path> folder_;
    Preferences saved_;
    Preferences newest_;
    double first_s_ = 0.0;  ///< when they first differed from `saved_`
    double last_s_ = 0.0;   ///< time of the last change
};

/// Writes the folder's file and makes the folder if it is missing. A failure is ignored: the
/// program works without the file.
void save_preferences(const std::filesystem::path& folder, const Preferences& preferences);

}  // namespace zeroset
