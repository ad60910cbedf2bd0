#include "engine/base/parallel.hpp"
#include "engine/base/translation.hpp"
#include "engine/export/new_file.hpp"
#include "engine/export/pictures/picture_makers.hpp"
#include "engine/export/pictures/pixel_rows.hpp"
#include "engine/image/background.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// A file of ours as OpenEXR writes into one.
class FileStream final : public Imf::OStream {
public:
    explicit FileStream(NewFile& file) : Imf::OStream("picture"), file_(file) {}
    void write(const char* bytes, int count) override {
        file_.append(std::as_bytes(std::span(bytes, static_cast<std::size_t>(count))));
    }
    std::uint64_t tellp() override { return static_cast<std::uint64_t>(file_.stream().tellp()); }
    void seekp(std::uint64_t place) override {
        file_.stream().seekp(static_cast<std::streamoff>(place));
    }

private:
    NewFile& file_;
};

/// All that is written of a pixel.
struct ExrPixel {
    std::array<float, 4> color;  ///< RGBA, multiplied by alpha
    float opacity;
    float depth;
    std::array<float, 3> position;
    std::array<float, 3> normal;
    std::uint32_t certificate;
    std::uint32_t surface;
};

struct Channel {
    const char* name;
    Imf::PixelType type;
    std::size_t offset;  ///< in ExrPixel
};

constexpr std::size_t float_bytes = sizeof(float);
constexpr Channel real(const char* name, std::size_t offset) {
    return {.name = name, .type = Imf::FLOAT, .offset = offset};
}
constexpr Channel whole(const char* name, std::size_t offset) {
    return {.name = name, .type = Imf::UINT, .offset = offset};
}

constexpr std::array<Channel, 14> exr_channels{
    real("R", offsetof(ExrPixel, color)),
    real("G", offsetof(ExrPixel, color) + float_bytes),
    real("B", offsetof(ExrPixel, color) + 2 * float_bytes),
    real("A", offsetof(ExrPixel, color) + 3 * float_bytes),
    real("opacity.A", offsetof(ExrPixel, opacity)),
    real("depth.Z", offsetof(ExrPixel, depth)),
    real("position.X", offsetof(ExrPixel, position)),
    real("position.Y", offsetof(ExrPixel, position) + float_bytes),
    real("position.Z", offsetof(ExrPixel, position) + 2 * float_bytes),
    real("normal.X", offsetof(ExrPixel, normal)),
    real("normal.Y", offsetof(ExrPixel, normal) + float_bytes),
    real("normal.Z", offsetof(ExrPixel, normal) + 2 * float_bytes),
    whole("certificate.id", offsetof(ExrPixel, certificate)),
    whole("surface.id", offsetof(ExrPixel, surface)),
};

/// Adds the session as attributes: of the keyword, and of the keyword with 2, 3, ... for the rest.
/// FFmpeg 5 and others take attributes of more than 255 bytes for a damaged file.
void add_document(Imf::Header& header, const std::string& document) {
    constexpr std::size_t longest = 255;
    for (std::size_t at = 0; at < document.size(); at += longest) {
        const std::size_t part = at / longest + 1;
        const std::string name = document_keyword + (part == 1 ? "" : " " + std::to_string(part));
        header.insert(name, Imf::StringAttribute(document.substr(at, longest)));
    }
}

Imf::Header header_of(const PictureOptions& options) {
    Imf::Header header(options.size.width, options.size.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const Channel& channel : exr_channels)
        header.channels().insert(channel.name, Imf::Channel(channel.type));
    header.insert("software", Imf::StringAttribute("Zeroset"));
    add_document(header, options.document);
    if (options.dots_per_inch > 0)
        Imf::addXDensity(header, static_cast<float>(options.dots_per_inch));
    return header;
}

class ExrPicture final : public PictureWriter {
public:
    ExrPicture(const std::filesystem::path& path, PictureOptions options)
        : options_(std::move(options)),
          view_(options_.camera),
          file_(path, NewFile::Order::Any),
          stream_(file_) {
        if (Imf::globalThreadCount() == 0) Imf::setGlobalThreadCount(core_count());
    }

    std::expected<void, FileError> add(const PictureBand& band) override;
    std::expected<void, FileError> finish() override;

private:
    [[nodiscard]] ExrPixel pixel(const PictureBand& band, int col, int row,
                                 const std::array<float, 3>& background) const;

    PictureOptions options_;
    ViewFrame view_;
    NewFile file_;
    FileStream stream_;
    std::optional<Imf::OutputFile> exr_;
};

ExrPixel ExrPicture::pixel(const PictureBand& band, int col, int row,
                           const std::array<float, 3>& background) const {
    const Framebuffer& frame = band.frame;
    const std::size_t at = frame.index(col, row);
    ExrPixel pixel{.color = pixel_light(band, at, background, options_.alpha),
                   .opacity = frame.light[at][3],
                   .depth = frame.depth[at],
                   .position = {},
                   .normal = frame.normal[at],
                   .certificate = static_cast<std::uint32_t>(frame.certificate[at]),
                   .surface = frame.surface[at]};
    for (std::size_t channel = 0; channel < 3; ++channel)
        pixel.color[channel] *= pixel.color[3];
    if (!std::isfinite(pixel.depth)) return pixel;
    const glm::vec3 point(view_.point(pixel_centre(col, band.row + row), options_.size,
                                      static_cast<double>(pixel.depth)));
    pixel.position = {point.x, point.y, point.z};
    return pixel;
}

std::expected<void, FileError> ExrPicture::add(const PictureBand& band) {
    const Framebuffer& frame = band.frame;
    const auto width = static_cast<std::size_t>(frame.width);
    std::vector<ExrPixel> pixels(frame.color.size());
    parallel_for(static_cast<std::size_t>(frame.height), 0, [&](std::size_t i) {
        const int row = static_cast<int>(i);
        const auto background =
            background_light(frame.background, band.row + row, options_.size.height);
        for (int col = 0; col < frame.width; ++col)
            pixels[frame.index(col, row)] = pixel(band, col, row, background);
    });
    Imf::FrameBuffer planes;
    for (const Channel& channel : exr_channels) {
        char* const first = reinterpret_cast<char*>(pixels.data()) + channel.offset;
        planes.insert(channel.name,
                      Imf::Slice::Make(channel.type, first, {0, band.row}, frame.width,
                                       frame.height, sizeof(ExrPixel), width * sizeof(ExrPixel)));
    }
    try {
        if (!exr_) exr_.emplace(stream_, header_of(options_));
        exr_->setFrameBuffer(planes);
        exr_->writePixels(frame.height);
    } catch (const std::exception& error) {
        return std::unexpected(
            FileError{filled(tr("cannot write the EXR file: {0}"), {error.what()})});
    }
    if (!file_.stream()) return file_.error();
    return {};
}

std::expected<void, FileError> ExrPicture::finish() {
    exr_.reset();  // writes the table of its lines
    return file_.keep();
}

}  // namespace

std::unique_ptr<PictureWriter> make_exr_picture(const std::filesystem::path& path,
                                                const PictureOptions& options) {
    return std::make_unique<ExrPicture>(path, options);
}

}  // namespace zeroset
