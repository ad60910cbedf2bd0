#pragma once

#include "ui/model/ui_state.hpp"
#include "ui/window/window.hpp"

#include <filesystem>
#include <optional>
#include <utility>

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

/// Keeps the folder's file as the preferences are: a moment after they have changed, so that a
/// window which is moved is not written at every step, and a crash takes no more than that moment.
class PreferencesFile {
public:
    static constexpr double rest_s = 1.0;     ///< without a change, before it is written
    static constexpr double longest_s = 5.0;  ///< from the first change, though they go on

    /// `saved`: as they are in the file. Without a folder nothing is kept.
    PreferencesFile(std::optional<std::filesystem::path> folder, const Preferences& saved)
        : folder_(std::move(folder)), saved_(saved), newest_(saved) {}

    /// What they are at `now_s` (any clock that does not go back).
    void follow(const Preferences& now, double now_s);
    /// Seconds until it wants to be called though nothing happens.
    [[nodiscard]] std::optional<double> due_s(double now_s) const;
    /// Writes what is not written yet.
    void finish();

private:
    [[nodiscard]] double due_at_s() const;

    std::optional<std::filesystem::path> folder_;
    Preferences saved_;
    Preferences newest_;
    double first_s_ = 0.0;  ///< when they became other than saved
    double last_s_ = 0.0;   ///< when they changed last
};

/// Makes the folder where it is missing. What cannot be written is left: the program works as well.
void save_preferences(const std::filesystem::path& folder, const Preferences& preferences);

}  // namespace zeroset
