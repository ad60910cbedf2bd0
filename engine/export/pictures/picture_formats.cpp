#include "engine/export/pictures/picture_formats.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/export/codecs/codec.hpp"
#include "engine/export/codecs/encoded_picture.hpp"
#include "engine/export/pictures/picture_makers.hpp"

#include <algorithm>
#include <vector>

namespace zeroset {
namespace {

constexpr int any_side = 65536;
/// Bytes of pixels that are gathered in memory for an encoder, which needs as much again, and more.
constexpr std::int64_t gathered = std::int64_t{256} << 20U;

constexpr std::array<PictureFormat, 8> known_pictures{{
    {.name = "PNG",
     .endings = {".png", ""},
     .about = marked("without loss, of any size; opens again as a session"),
     .bits = {8, 16},
     .alpha = true,
     .lossy = false,
     .density = true,
     .document = true,
     .largest_side = any_side,
     .most_bytes = 0,
     .encoder = nullptr,
     .make = make_png_picture},
    {.name = "JPEG",
     .endings = {".jpg", ".jpeg"},
     .about = marked("small files, with losses"),
     .bits = {8, 8},
     .alpha = false,
     .lossy = true,
     .density = false,
     .document = false,
     .largest_side = 65500,
     .most_bytes = gathered,
     .encoder = nullptr,
     .make = make_jpeg_picture},
    {.name = "WebP",
     .endings = {".webp", ""},
     .about = marked("smaller files for the web; without loss at quality 100"),
     .bits = {8, 8},
     .alpha = true,
     .lossy = true,
     .density = false,
     .document = false,
     .largest_side = 16383,
     .most_bytes = gathered,
     .encoder = webp_encoder,
     .make = make_webp_picture},
    {.name = "TIFF",
     .endings = {".tif", ".tiff"},
     .about = marked("without loss, for printers"),
     .bits = {8, 16},
     .alpha = true,
     .lossy = false,
     .density = true,
     .document = false,
     .largest_side = any_side,
     .most_bytes = gathered,
     .encoder = tiff_encoder,
     .make = make_tiff_picture},
    {.name = "OpenEXR",
     .endings = {".exr", ""},
     .about =
         marked("light in full precision with depth, position, normal and certificate as layers"),
     .bits = {32, 32},
     .alpha = true,
     .lossy = false,
     .density = true,
     .document = true,
     .largest_side = any_side,
     .most_bytes = 0,
     .encoder = nullptr,
     .make = make_exr_picture},
    {.name = "BMP",
     .endings = {".bmp", ""},
     .about = marked("without loss and not packed, for old programs"),
     .bits = {8, 8},
     .alpha = false,
     .lossy = false,
     .density = false,
     .document = false,
     .largest_side = 65500,
     .most_bytes = gathered,
     .encoder = nullptr,
     .make = make_bmp_picture},
    {.name = "TGA",
     .endings = {".tga", ""},
     .about = marked("without loss, for textures"),
     .bits = {8, 8},
     .alpha = true,
     .lossy = false,
     .density = false,
     .document = false,
     .largest_side = 65500,
     .most_bytes = gathered,
     .encoder = nullptr,
     .make = make_tga_picture},
    {.name = "Radiance HDR",
     .endings = {".hdr", ""},
     .about = marked("light in three bytes and a common exponent"),
     .bits = {32, 32},
     .alpha = false,
     .lossy = false,
     .density = false,
     .document = false,
     .largest_side = 32767,
     .most_bytes = gathered,
     .encoder = nullptr,
     .make = make_hdr_picture},
}};

bool has_bits(const PictureFormat& format, int bits) {
    return std::ranges::find(format.bits, bits) != format.bits.end();
}

/// "; type a name that ends in ..." with the endings of the formats that can; or nothing.
template <class Can>
std::string other_ending(const Can& can) {
    std::vector<std::string_view> endings;
    for (const PictureFormat& format : known_pictures) {
        if (can(format) && missing_part(format).empty()) endings.push_back(format.endings[0]);
    }
    return endings.empty() ? ""
                           : "; " + filled(tr("type a name that ends in {0}"), {one_of(endings)});
}

/// "8 or 16": the bits a channel that a format can have.
std::string bits_of(const PictureFormat& format) {
    const auto [least, most] = std::ranges::minmax(format.bits);
    return least == most ? std::to_string(most)
                         : filled(tr("{0} or {1}"), {std::to_string(least), std::to_string(most)});
}

std::string size_text(const ImageSize& size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

std::optional<std::string> size_refusal(const PictureFormat& format,
                                        const PictureOptions& options) {
    const int side = std::max(options.size.width, options.size.height);
    const std::string name(format.name);
    const std::string instead = std::string("; ") + tr("PNG can: type a name that ends in .png");
    if (side > format.largest_side) {
        return filled(tr("a {0} cannot be larger than {1} pixels a side"),
                      {name, std::to_string(format.largest_side)}) +
               instead;
    }
    const std::int64_t channels = options.alpha ? 4 : 3;
    const std::int64_t bytes =
        std::int64_t{options.size.width} * options.size.height * channels * options.bits / 8;
    if (format.most_bytes > 0 && bytes > format.most_bytes) {
        return filled(tr("a {0} of {1} pixels would need too much memory"),
                      {name, size_text(options.size)}) +
               instead;
    }
    return std::nullopt;
}

}  // namespace

std::span<const PictureFormat> picture_formats() { return known_pictures; }

const PictureFormat* picture_format_of(const std::filesystem::path& path) {
    const std::string ending = lower_case(path.extension().string());
    const auto* const found =
        std::ranges::find_if(known_pictures, [&](const PictureFormat& format) {
            return !ending.empty() &&
                   std::ranges::find(format.endings, ending) != format.endings.end();
        });
    return found == known_pictures.end() ? nullptr : found;
}

std::string missing_part(const PictureFormat& format) {
    return format.encoder == nullptr ? "" : missing_encoder(format.encoder);
}

std::optional<std::string> refusal(const PictureFormat& format, const PictureOptions& options) {
    const std::string name(format.name);
    if (const std::string missing = missing_part(format); !missing.empty())
        return filled(tr("no {0}: {1}; type a name that ends in .png"), {name, missing});
    if (options.alpha && !format.alpha)
        return filled(tr("a {0} cannot be transparent"), {name}) +
               other_ending([](const PictureFormat& other) { return other.alpha; });
    if (!has_bits(format, options.bits)) {
        const std::string other =
            other_ending([&](const PictureFormat& row) { return has_bits(row, options.bits); });
        return filled(tr("a {0} cannot have {1} bits a channel"),
                      {name, std::to_string(options.bits)}) +
               (other.empty() ? "; " + filled(tr("type {0}"), {bits_of(format)}) : other);
    }
    return size_refusal(format, options);
}

bool needs_light(const PictureOptions& options) { return options.bits > 8; }
bool needs_normals(const PictureOptions& options) { return options.bits > 16; }

std::expected<std::unique_ptr<PictureWriter>, FileError> begin_picture(
    const PictureFormat& format, const std::filesystem::path& path, const PictureOptions& options) {
    if (auto writable = check_writable(path); !writable) return std::unexpected(writable.error());
    return format.make(path, options);
}

}  // namespace zeroset
