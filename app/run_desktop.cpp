#include "app/commands.hpp"
#include "app/desktop.hpp"
#include "app/document_files.hpp"
#include "app/folders.hpp"
#include "app/gallery.hpp"
#include "app/options.hpp"
#include "app/preferences.hpp"
#include "app/progress.hpp"
#include "ui/window.hpp"

#include <algorithm>
#include <chrono>
#include <expected>
#include <iostream>
#include <optional>
#include <string>
#include <utility>

namespace zeroset {
namespace {

std::optional<double> earlier(const std::optional<double>& a, const std::optional<double>& b) {
    return a && b ? std::min(*a, *b) : a ? a : b;
}

}  // namespace

OrInputError<DesktopOptions> read_desktop_options(const std::string& equation, const ViewText& view,
                                                  const TraceText& trace) {
    const std::string first = "@" + gallery().front().name;
    const auto surface = read_surface(equation.empty() ? first : equation, view);
    if (!surface) return std::unexpected(surface.error());
    auto settings = read_trace_settings(trace);
    if (!settings) return std::unexpected(settings.error());
    DesktopOptions options;
    options.document = document_of(*surface);
    options.equation = surface->equation;
    options.given = surface->parameters;
    options.solids = surface->solids;
    if (surface->document) {
        options.path = equation;
        if (const auto loaded = load_document(equation)) options.note = loaded->note;
    }
    if (trace.d_stop || trace.epsilon || trace.delta) options.document.stop = settings->stop;
    take_look(trace, options.document);
    options.fit = view.fit;
    options.fits_box = !view.fit || !view.box;
    options.settings = std::move(*settings);
    return options;
}

int run_desktop(const DesktopOptions& options) {
    const auto folder = config_folder();
    const Preferences before = folder ? load_preferences(*folder) : Preferences();
    auto window = ui::make_glfw_window({.size = before.window});
    if (!window) {
        std::cerr << "zeroset: " << window.error()
                  << "; `zeroset render \"EQUATION\" -o out.png` works without a display\n";
        return exit_run_time;
    }
    DesktopOptions taken_over = options;
    taken_over.on_desktop = true;
    taken_over.layout = before.layout;
    taken_over.theme = before.theme.value_or(before.last_theme);
    taken_over.follows_desktop = !before.theme;
    Desktop desktop(**window, taken_over);
    PreferencesFile kept(folder, before);
    while (!desktop.closed()) {
        (*window)->wait(earlier(desktop.due_s(), kept.due_s(desktop.now_s())));
        desktop.draw_frame();
        kept.follow(desktop.preferences(), desktop.now_s());
        if (!(*window)->is_lost()) continue;
        desktop.abandon();
        kept.finish();
        return report_run_time(
            "the graphics driver has lost the window; what was open is kept: start zeroset again");
    }
    kept.finish();
    end_process_after(std::chrono::milliseconds(500), exit_ok);  // LLVM may take its time
    return exit_ok;
}

}  // namespace zeroset
