#include "engine/export/new_file.hpp"
#include "engine/export/pictures/picture_makers.hpp"
#include "engine/export/pictures/pixel_rows.hpp"
#include "engine/export/png_writer.hpp"

#include <span>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

PngFormat png_format(const PictureOptions& options) {
    PngFormat format{.width = options.size.width,
                     .height = options.size.height,
                     .channels = options.alpha ? 4 : 3,
                     .bits = options.bits,
                     .dots_per_inch = options.dots_per_inch,
                     .texts = {{.keyword = "Software", .text = "Zeroset"}}};
    if (!options.document.empty())
        format.texts.push_back({.keyword = document_keyword, .text = options.document});
    return format;
}

class PngPicture final : public PictureWriter {
public:
    PngPicture(const std::filesystem::path& path, PictureOptions options)
        : options_(std::move(options)),
          file_(path),
          png_(png_format(options_),
               [this](std::span<const std::byte> bytes) { return file_.append(bytes); }) {}

    std::expected<void, FileError> add(const PictureBand& band) override {
        const PixelLayout layout{
            .bits = options_.bits, .alpha = options_.alpha, .order = std::endian::big};
        take_pixel_rows(band, options_.size.height, layout, rows_);
        if (!png_.add_rows(rows_)) return file_.error();
        return {};
    }
    std::expected<void, FileError> finish() override {
        if (!png_.finish()) return file_.error();
        return file_.keep();
    }

private:
    PictureOptions options_;
    NewFile file_;
    PngWriter png_;
    std::vector<std::uint8_t> rows_;  ///< memory, kept from band to band
};

}  // namespace

std::unique_ptr<PictureWriter> make_png_picture(const std::filesystem::path& path,
                                                const PictureOptions& options) {
    return std::make_unique<PngPicture>(path, options);
}

}  // namespace zeroset
