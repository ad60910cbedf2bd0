#include "app/desktop/picture_export.hpp"

#include "document/json/document_json.hpp"
#include "engine/export/pictures/picture_formats.hpp"
#include "engine/render/color_range.hpp"
#include "pipeline/plans/poster.hpp"

#include <chrono>
#include <memory>
#include <utility>

namespace zeroset {
namespace {

/// Pixels of the file along a side of one of the window's.
constexpr int finer = 2;

/// The scene of a request, with the range of its colours.
Scene finished_scene(const PictureRequest& request, const TimeLimit& limit) {
    Scene scene = scene_of(request);
    if (has_range(scene.coloring.by) && !scene.coloring.range) {
        scene.coloring.range = find_range(scene, request.camera, request.settings,
                                          request.size_px.x, request.size_px.y, limit);
    }
    return scene;
}

}  // namespace

PictureExport::~PictureExport() { cancel_ = true; }

void PictureExport::start(PictureRequest request, Document document,
                          const std::filesystem::path& path) {
    name_ = path.filename().string();
    cancel_ = false;
    done_ = 0;
    request.size_px *= finer;
    pixels_ = static_cast<std::uint64_t>(request.size_px.x) *
              static_cast<std::uint64_t>(request.size_px.y);
    if (request.settings.antialias == Antialias::None)
        request.settings.antialias = Antialias::Beams;
    work_ = std::async(std::launch::async, [this, request = std::move(request),
                                            document = std::move(document), path]() mutable {
        Outcome outcome = write(std::move(request), document, path);
        on_end_();
        return outcome;
    });
}

PictureExport::Outcome PictureExport::write(PictureRequest request, const Document& document,
                                            const std::filesystem::path& path) {
    const PictureFormat* const format = picture_format_of(path);
    if (format == nullptr)
        return std::unexpected("the picture was not saved: type a name that ends in " +
                               picture_endings());
    add_needed_code(request);
    const PictureOptions options{.size = {.width = request.size_px.x, .height = request.size_px.y},
                                 .bits = format->bits[0],
                                 .document = text_of(document),
                                 .camera = request.camera};
    if (const auto refused = refusal(*format, options)) return std::unexpected(*refused);
    auto writer = begin_picture(*format, path, options);
    if (!writer) return std::unexpected(writer.error().message);
    const Poster poster{.scene = finished_scene(request, {.cancel = &cancel_}),
                        .camera = request.camera,
                        .settings = request.settings,
                        .size = options.size,
                        .document = document,
                        .keeps_light = needs_light(options),
                        .keeps_normals = needs_normals(options)};
    const auto drawn = draw_poster(
        poster, [&](const PictureBand& band) { return (*writer)->add(band); },
        {.cancel = &cancel_, .on_pixels = [this](std::uint64_t pixels) { done_ += pixels; }});
    if (!drawn) return std::unexpected(drawn.error());
    if (const auto kept = (*writer)->finish(); !kept) return std::unexpected(kept.error().message);
    return "saved " + name_ + " (" + std::to_string(options.size.width) + "x" +
           std::to_string(options.size.height) + ")";
}

std::string PictureExport::doing() const {
    if (!runs()) return "";
    return "saving " + name_ + ", " + std::to_string(100 * done_ / pixels_) + " %";
}

std::optional<std::expected<std::string, std::string>> PictureExport::take() {
    if (!runs() || work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    return work_.get();
}

}  // namespace zeroset
