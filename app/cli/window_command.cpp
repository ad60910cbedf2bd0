#include "app/cli/window_command.hpp"

#include "pipeline/gallery.hpp"
#include "pipeline/input_error.hpp"

#include <expected>
#include <utility>

namespace zeroset {

OrInputError<DesktopOptions> read_desktop_options(const std::string& equation, const ViewText& view,
                                                  const TraceText& trace, TextErrors errors) {
    const std::string first = "@" + gallery().front().name;
    auto input = read_document(equation.empty() ? first : equation, view);
    if (!input) return std::unexpected(input.error());
    auto settings = read_trace_settings(trace);
    if (!settings) return std::unexpected(settings.error());
    if (trace.levels) {
        return wrong_input("--levels " + *trace.levels +
                           ": the window has --dstop only; type zeroset render for a picture");
    }
    if (!input->rows && input->path.empty() && errors == TextErrors::Refused)
        return std::unexpected(input->rows.error());
    DesktopOptions options;
    options.document = std::move(input->document);
    // The window has a background of its own theme.
    if (input->shown_on && options.document.light.background == input->shown_on)
        options.document.light.background.reset();
    options.path = input->path;
    options.note = input->note;
    if (trace.d_stop || trace.epsilon || trace.delta) options.document.stop = settings->stop;
    if (const auto wrong = take_look(trace, options.document)) return std::unexpected(*wrong);
    options.is_new =
        !input->stored && !trace.axes && !trace.clip_box && !trace.grid && !trace.textbook;
    options.fit = view.fit;
    options.fits_box = !view.fit || !view.box;
    options.settings = std::move(*settings);
    return options;
}

}  // namespace zeroset
