#include "app/cli/window_command.hpp"

#include "document/json/document_file.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/input_error.hpp"

#include <expected>
#include <utility>

namespace zeroset {

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

}  // namespace zeroset
