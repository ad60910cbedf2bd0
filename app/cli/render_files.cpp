#include "app/cli/render_files.hpp"

#include "document/json/document_json.hpp"
#include "engine/base/clock.hpp"
#include "engine/export/pictures/picture_makers.hpp"
#include "engine/image/frame_pictures.hpp"
#include "pipeline/finish_picture.hpp"
#include "pipeline/periodic_axes.hpp"
#include "pipeline/plans/export_formats.hpp"
#include "pipeline/shown_points.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace zeroset {
namespace {

constexpr double least_density = 1.0;
constexpr double largest_density = 100'000.0;

std::optional<InputError> read_numbers_of(const RenderCommand& command, PictureOptions& options) {
    if (command.bits) {
        const auto bits = read_integer("--bits", *command.bits, 8, 32);
        if (!bits) return bits.error();
        options.bits = *bits;
    }
    if (command.dpi) {
        const auto density = read_number("--dpi", *command.dpi);
        if (!density) return density.error();
        if (!(*density >= least_density && *density <= largest_density))
            return InputError{.reason = "--dpi " + *command.dpi + ": type 1 to 100000"};
        options.dots_per_inch = *density;
    }
    if (command.quality) {
        const auto quality = read_integer("--quality", *command.quality, 1, 100);
        if (!quality) return quality.error();
        options.quality = *quality;
    }
    return std::nullopt;
}

void add_counts(const CertificateCounts& counts, CertificateCounts& total) {
    total.certified += counts.certified;
    total.undecided += counts.undecided;
    total.miss += counts.miss;
    total.coarse += counts.coarse;
    total.not_drawn += counts.not_drawn;
    total.jumps += counts.jumps;
}

}  // namespace

OrInputError<PictureOptions> read_picture_options(const RenderCommand& command, const Size& size) {
    PictureOptions options{.size = {.width = size.width, .height = size.height},
                           .alpha = command.alpha};
    if (!command.output) {
        for (const auto& [name, given] :
             {std::pair{"--alpha", command.alpha}, std::pair{"--bits", command.bits.has_value()},
              std::pair{"--dpi", command.dpi.has_value()},
              std::pair{"--quality", command.quality.has_value()}}) {
            if (given)
                return wrong_input(std::string(name) + ": there is no picture without -o FILE");
        }
        return options;
    }
    const std::string option = "-o " + *command.output;
    const PictureFormat* const format = picture_format_of(*command.output);
    if (format == nullptr)
        return wrong_input(option + ": " + other_name(ExportKind::Picture, *command.output));
    options.bits = format->bits[0];
    if (const auto wrong = read_numbers_of(command, options)) return std::unexpected(*wrong);
    if (const auto refused = refusal(*format, options))
        return wrong_input(option + ": " + *refused);
    if (command.quality && !format->lossy) {
        return wrong_input("--quality " + *command.quality + ": a " + std::string(format->name) +
                           " loses nothing" +
                           export_use(ExportKind::Picture, &ExportFormat::quality));
    }
    if (command.dpi && !format->density) {
        return wrong_input("--dpi " + *command.dpi + ": a " + std::string(format->name) +
                           " cannot tell it here" +
                           export_use(ExportKind::Picture, &ExportFormat::density));
    }
    return options;
}

std::expected<void, FileError> RenderFiles::begin(const RenderedPicture& picture) {
    begun_ = true;
    const Size& size = picture.plan.size;
    surfaces_.resize(picture.scene.surfaces.size());
    if (command_.output) {
        PictureOptions options = picture.plan.picture;
        options.camera = picture.request.camera;
        if (!command_.no_session) options.document = text_of(picture.plan.document);
        auto begun = begin_picture(*picture_format_of(*command_.output), *command_.output, options);
        if (!begun) return std::unexpected(begun.error());
        picture_ = std::move(*begun);
    }
    if (command_.depth)
        depth_ = std::make_unique<PfmWriter>(*command_.depth, size.width, size.height);
    if (command_.certificate)
        certificate_ = make_png_picture(*command_.certificate,
                                        {.size = {.width = size.width, .height = size.height}});
    if (command_.cost)
        cost_ = make_png_picture(*command_.cost,
                                 {.size = {.width = size.width, .height = size.height}});
    return {};
}

std::expected<void, FileError> RenderFiles::add(const RenderedPicture& picture,
                                                const PictureBand& band) {
    const auto start = std::chrono::steady_clock::now();
    auto written = write(picture, band);
    writing_ms_ += ms_since(start);
    if (command_.stats) count(band.frame);
    return written;
}

std::expected<void, FileError> RenderFiles::write(const RenderedPicture& picture,
                                                  const PictureBand& band) {
    std::expected<void, FileError> written;
    if (!begun_) written = begin(picture);
    if (written && picture_ != nullptr) written = picture_->add(band);
    if (written && depth_ != nullptr) written = depth_->add(band.frame, band.row);
    if (written && certificate_ != nullptr) {
        const Framebuffer colors = certificate_picture(band.frame);
        written = certificate_->add({.frame = colors, .painted = colors, .row = band.row});
    }
    if (written && cost_ != nullptr) {
        Framebuffer colors = band.frame;
        colors.color = cost_colors(band.frame);
        written = cost_->add({.frame = colors, .painted = colors, .row = band.row});
    }
    return written;
}

void RenderFiles::count(const Framebuffer& band) {
    add_counts(count_certificates(band), certificates_);
    const auto shown = count_surfaces(band, surfaces_.size());
    for (std::size_t i = 0; i < shown.size(); ++i)
        surfaces_[i] += shown[i];
}

std::expected<void, FileError> RenderFiles::finish() {
    const auto start = std::chrono::steady_clock::now();
    std::expected<void, FileError> written;
    if (picture_ != nullptr) written = picture_->finish();
    if (written && depth_ != nullptr) written = depth_->finish();
    if (written && certificate_ != nullptr) written = certificate_->finish();
    if (written && cost_ != nullptr) written = cost_->finish();
    writing_ms_ += ms_since(start);
    return written;
}

std::expected<void, std::string> add_whole(const RenderCommand& command,
                                           const std::shared_ptr<const RenderedPicture>& made,
                                           RenderFiles& files) {
    const std::vector<ShownPoint> points =
        shown_points(made->request.formula.get(), made->plan.document, made->request.camera,
                     made->request.size_px.y);
    const FrameSubject subject{.document = made->plan.document,
                               .camera = made->request.camera,
                               .coloring = made->scene.coloring,
                               .uniforms = made->scene.uniforms,
                               .section_values = made->scene.section_values,
                               .legend = made->plan.legend,
                               .points = points,
                               .of_pi = made->request.formula
                                            ? periodic_axes(*made->request.formula->program)
                                            : std::array<bool, 3>{},
                               .transparent = command.alpha};
    const std::shared_ptr<const Framebuffer> frame(made, &made->frame);
    std::expected<std::shared_ptr<const Framebuffer>, std::string> painted = frame;
    if (command.output) painted = finish_picture(frame, subject);
    if (!painted) return std::unexpected(painted.error());
    const auto added = files.add(*made, {.frame = *frame, .painted = **painted, .row = 0});
    if (!added) return std::unexpected(added.error().message);
    return {};
}

}  // namespace zeroset
