#include "app/desktop/desktop.hpp"
#include "app/desktop/preferences.hpp"
#include "app/platform/folders.hpp"
#include "app/platform/process.hpp"
#include "engine/base/language.hpp"
#include "ui/window/window.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <expected>
#include <optional>
#include <string>
#include <utility>

namespace zeroset {
namespace {

std::optional<double> earlier(const std::optional<double>& a, const std::optional<double>& b) {
    return a && b ? std::min(*a, *b) : a ? a : b;
}

}  // namespace

std::expected<void, std::string> run_desktop(const DesktopOptions& options) {
    const auto folder = config_folder();
    const Preferences before = folder ? load_preferences(*folder) : Preferences();
    auto window = ui::make_glfw_window({.size = before.window});
    if (!window) {
        return std::unexpected(
            window.error() + "; `zeroset render \"EQUATION\" -o out.png` works without a display");
    }
    DesktopOptions taken_over = options;
    taken_over.on_desktop = true;
    taken_over.opens_last = options.opens_last && before.layout.begins_with_last;
    taken_over.layout = before.layout;
    taken_over.desktop_language = desktop_language(locale_variables());
    if (options.is_new) ui::show_as_new(taken_over.document, before.layout);
    if (options.has_new_edges) ui::smooth_as_new(taken_over.document, before.layout);
    taken_over.theme = before.theme.value_or(before.last_theme);
    taken_over.follows_desktop = !before.theme;
    taken_over.tour = options.tour && !before.tour_seen;
    taken_over.tour_seen = before.tour_seen;
    Desktop desktop(**window, taken_over);
    PreferencesFile kept(folder, before);
    while (!desktop.closed()) {
        (*window)->wait(earlier(desktop.due_s(), kept.due_s(desktop.now_s())));
        desktop.draw_frame();
        kept.follow(desktop.preferences(), desktop.now_s());
        if (!(*window)->is_lost()) continue;
        desktop.abandon();
        kept.finish();
        return std::unexpected(
            "the graphics driver has lost the window; what was open is kept: start zeroset again");
    }
    kept.finish();
    end_process_after(std::chrono::milliseconds(500), EXIT_SUCCESS);  // LLVM may still be compiling
    return {};
}

}  // namespace zeroset
