#include "papers/commands/compare_scene.hpp"

#include "pipeline/prepare.hpp"
#include "pipeline/volume_source.hpp"

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

BenchItem item_of(const PrintedScene& scene) {
    BenchItem item{.name = scene.name,
                   .read = read_document_text(scene.formula, volume_source({}))};
    item.read.document.clip = Box::cube(scene.domain);
    item.read.document.camera = suite_camera(scene.domain);
    return item;
}

OrInputError<PictureRequest> compiled(const BenchItem& item, const TraceSettings& settings,
                                      const Size& size) {
    if (!item.read.rows) return std::unexpected(item.read.rows.error());
    Document document = item.read.document;
    document.light = {};
    document.antialias = Antialias::None;
    const auto prepared = prepare(document, *item.read.rows, Preparation::Compiled);
    if (!prepared) return std::unexpected(prepared.error());
    PictureRequest request = picture_request(prepared->formula, prepared->colors, document,
                                             settings, {size.width, size.height});
    add_needed_code(request);
    return request;
}

}  // namespace zeroset
