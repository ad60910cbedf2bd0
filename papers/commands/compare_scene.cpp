#include "papers/commands/compare_scene.hpp"

#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"

#include <array>
#include <string>
#include <utility>

namespace zeroset {
namespace {

/// The first option that tables alone have, as it is typed; nullptr: there is none.
const char* unfit_option(const CompareCommand& command) {
    const std::array<std::pair<const std::optional<std::string>*, const char*>, 4> options{
        {{&command.surfaces, "--surface"},
         {&command.tracers, "--tracer"},
         {&command.repeat, "--repeat"},
         {&command.budget, "--budget"}}};
    for (const auto& [value, name] : options) {
        if (*value) return name;
    }
    return nullptr;
}

}  // namespace

OrInputError<ComparedSettings> read_compared_settings(const CompareCommand& command,
                                                      std::string_view what, const char* d_stop,
                                                      int size_px) {
    if (const char* const option = unfit_option(command))
        return wrong_input(std::string(option) + ": " + std::string(what) +
                           "; leave the option out");
    TraceText text;
    text.d_stop = command.d_stop.value_or(d_stop);
    text.threads = command.threads.value_or("1");
    auto settings = read_trace_settings(text);
    if (!settings) return std::unexpected(settings.error());
    const auto size = read_size("--size", command.size.value_or(std::to_string(size_px)));
    if (!size) return std::unexpected(size.error());
    if (size->width != size->height)
        return wrong_input("--size " + *command.size + ": " + std::string(what) +
                           ", and a square; type N");
    return ComparedSettings{.settings = std::move(*settings), .size_px = size->width};
}

OrInputError<ComparedScene> compared_scene(std::string_view formula, double domain,
                                           const ComparedSettings& settings) {
    ReadDocument read = read_document_text(formula);
    if (!read.rows) return std::unexpected(read.rows.error());
    read.document.clip = Box::cube(domain);
    read.document.camera = suite_camera(domain);
    read.document.light = {};
    const auto prepared = prepare(read.document, *read.rows, Preparation::Compiled);
    if (!prepared) return std::unexpected(prepared.error());
    PictureRequest request =
        picture_request(prepared->formula, prepared->colors, read.document, settings.settings,
                        {settings.size_px, settings.size_px});
    add_needed_code(request);
    return ComparedScene{.scene = scene_of(request), .camera = request.camera};
}

}  // namespace zeroset
