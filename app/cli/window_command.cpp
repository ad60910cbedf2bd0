#include "app/cli/window_command.hpp"

#include "app/cli/options/view_options.hpp"
#include "document/json/collection.hpp"
#include "engine/volume/files/volume_file.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/input_error.hpp"

#include <expected>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

namespace zeroset {
namespace {

/// The documents to choose from where EQUATION is a folder, or a file with several. A folder's name
/// without a / may be a formula.
std::expected<std::optional<Collection>, std::string> typed_collection(
    const std::string& equation) {
    std::error_code error;
    const bool is_path = equation.contains('/') || equation == "." || equation == "..";
    const bool is_formula = !is_path && std::filesystem::is_directory(equation, error);
    if (is_formula || is_volume_file(equation)) return std::nullopt;
    return collection_at(equation);
}

}  // namespace

OrInputError<DesktopOptions> read_desktop_options(const std::string& equation, const ViewText& view,
                                                  const TraceText& trace, TextErrors errors) {
    const std::string first = "@" + gallery().front().name;
    auto collection = typed_collection(equation);
    if (!collection) return wrong_input(collection.error());
    ViewText quiet = view;  // the window shows notes beside the rows
    quiet.quiet = true;
    DesktopOptions options;
    auto input =
        read_document(equation.empty() || *collection ? first : equation, quiet, options.files);
    if (!input) return std::unexpected(input.error());
    auto settings = read_trace_settings(trace);
    if (!settings) return std::unexpected(settings.error());
    if (trace.levels) {
        return wrong_input("--levels " + *trace.levels +
                           ": the window has --dstop only; type zeroset render for a picture");
    }
    if (!input->rows && input->path.empty() && errors == TextErrors::Refused)
        return std::unexpected(input->rows.error());
    const bool is_free = has_free_view(*input, view);
    options.document = std::move(input->document);
    // The window has a background of its own theme.
    if (input->shown_on && options.document.light.background == input->shown_on)
        options.document.light.background.reset();
    options.path = input->path;
    options.note = input->note;
    options.collection = std::move(*collection);
    if (trace.d_stop || trace.epsilon || trace.delta) options.document.stop = settings->stop;
    if (const auto wrong = take_look(trace, options.document)) return std::unexpected(*wrong);
    options.is_new =
        !input->stored && !trace.axes && !trace.clip_box && !trace.grid && !trace.textbook;
    options.has_new_edges = !input->stored && !trace.aa && !trace.antialias;
    options.opens_last = equation.empty();
    options.fit = view.fit;
    options.fits_box = !view.fit || !view.box;
    options.frames_box = !input->stored && !chooses_camera(view);
    options.fits_itself = is_free;
    options.settings = std::move(*settings);
    return options;
}

}  // namespace zeroset
