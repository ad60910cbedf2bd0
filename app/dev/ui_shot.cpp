#include "app/cli/options/option_reader.hpp"
#include "app/cli/options/options.hpp"
#include "app/cli/report.hpp"
#include "app/cli/window_command.hpp"
#include "app/desktop/desktop.hpp"
#include "app/dev/dev_commands.hpp"
#include "engine/base/language.hpp"
#include "engine/export/file.hpp"
#include "engine/export/png.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/language/vocabulary/nearest_word.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/input_error.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/theme.hpp"
#include "ui/window/offscreen_window.hpp"
#include "ui/window/window.hpp"

#include <glm/ext/vector_float2.hpp>

#include <algorithm>
#include <expected>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// The meaning of the options, checked before any work.
struct UiShotPlan {
    DesktopOptions desktop;
    ui::OffscreenOptions window;
    std::optional<glm::vec2> pointer;  ///< position in pixels
};

OrInputError<ui::Theme> read_theme(const std::string& text) {
    if (const auto theme = ui::theme_named(text)) return *theme;
    return wrong_input("--theme " + text + ": type dark or light");
}

OrInputError<Language> read_language(const std::string& text) {
    if (const auto language = language_named(text)) return *language;
    return wrong_input("--language " + text + ": type en, de, fr or es");
}

OrInputError<ui::OffscreenOptions> read_window(const UiShotCommand& command) {
    constexpr double largest_scale = 4.0;
    constexpr double largest_side = 16384.0;
    const auto size = read_size("--size", command.size);
    if (!size) return std::unexpected(size.error());
    const auto scale = read_number("--scale", command.scale);
    if (!scale) return std::unexpected(scale.error());
    if (!(*scale >= 1.0 && *scale <= largest_scale))
        return wrong_input("--scale " + command.scale + ": type a number from 1 to 4");
    if (size->width < ui::min_width || size->height < ui::min_height) {
        return wrong_input("--size " + command.size + ": the window is at least " +
                           std::to_string(ui::min_width) + "x" + std::to_string(ui::min_height));
    }
    const int largest = static_cast<int>(largest_side / *scale);
    if (size->width > largest || size->height > largest) {
        return wrong_input("--size " + command.size + ": at --scale " + command.scale +
                           " each side must be at most " + std::to_string(largest));
    }
    return ui::OffscreenOptions{
        .width = size->width, .height = size->height, .scale = static_cast<float>(*scale)};
}

OrInputError<std::optional<glm::vec2>> read_pointer(const std::optional<std::string>& text,
                                                    float scale) {
    if (!text) return std::nullopt;
    const auto at = read_numbers("--pointer", *text, 2);
    if (!at) return std::unexpected(at.error());
    return scale * glm::vec2((*at)[0], (*at)[1]);
}

OrInputError<std::vector<const ui::Action*>> read_actions(const std::vector<std::string>& names) {
    std::vector<std::string_view> known;
    std::ranges::transform(ui::actions(), std::back_inserter(known), &ui::Action::name);
    std::vector<const ui::Action*> found;
    for (const std::string& name : names) {
        if (std::ranges::find(known, name) == known.end()) {
            const auto meant = meant_word(name, known);
            return wrong_input("--do " + name + ": there is no such action" +
                               (meant ? "; did you mean '" + std::string(*meant) + "'?"
                                      : "; Ctrl+K in the window lists them"));
        }
        found.push_back(&ui::action_named(name));
    }
    return found;
}

OrInputError<UiShotPlan> plan_of(const UiShotCommand& command) {
    if (command.output.empty()) return wrong_input("nothing to write: give -o UI.png");
    if (!command.output.ends_with(".png")) {
        return wrong_input("-o " + command.output +
                           ": the picture is a PNG; type a name that ends in .png");
    }
    UiShotPlan plan;
    ui::Theme theme = ui::Theme::Dark;
    Language language = Language::English;
    OptionReader reader;
    reader.take(plan.window, read_window(command));
    reader.take(theme, read_theme(command.theme));
    reader.take(language, read_language(command.language));
    if (reader.error()) return std::unexpected(*reader.error());
    DesktopOptions& desktop = plan.desktop;
    reader.take(desktop, read_desktop_options(command.equation, command.view, command.trace));
    reader.take(desktop.actions, read_actions(command.actions));
    reader.take(plan.pointer, read_pointer(command.pointer, plan.window.scale));
    desktop.theme = theme;
    desktop.layout.language = language;
    desktop.takes_keyboard = false;  // no selected text and no text cursor
    desktop.keeps_files = false;
    desktop.opens_last = false;
    desktop.note.clear();
    if (command.mark_undecided) desktop.document.mark_undecided = true;
    return reader.finish(std::move(plan));
}

/// Returns the window's pixels once nothing in the window changes any more.
Framebuffer draw_settled(ui::OffscreenWindow& window, const DesktopOptions& options,
                         const std::optional<glm::vec2>& pointer) {
    Desktop desktop(window, options);
    if (pointer) ui::OffscreenWindow::point(*pointer, false);
    while (!desktop.settled()) {
        window.wait(desktop.due_s());
        desktop.draw_frame();
    }
    for (int frame = 0; frame < ui::frames_to_settle; ++frame) {
        desktop.draw_frame();
    }
    return window.pixels();
}

}  // namespace

int run_ui_shot(const UiShotCommand& command) {
    const auto plan = plan_of(command);
    if (!plan) return report(plan.error());
    if (const auto writable = check_writable(command.output); !writable) {
        return report_run_time(writable.error().message);
    }
    const auto window = ui::make_offscreen_window(plan->window);
    if (!window) {
        return report_run_time(window.error() +
                               "; `zeroset render \"EQUATION\" -o out.png` needs no OpenGL");
    }
    const auto written =
        write_file(command.output, png_of(draw_settled(**window, plan->desktop, plan->pointer)));
    return written ? exit_ok : report_run_time(written.error().message);
}

}  // namespace zeroset
