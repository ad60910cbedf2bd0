#include "engine/base/translation.hpp"
#include "engine/export/codecs/encoded_picture.hpp"

#include <stb/stb_image_write.h>

namespace zeroset {
namespace {

void append_bytes(void* to, void* data, int size) {
    const auto* const first = static_cast<const std::byte*>(data);
    auto& bytes = *static_cast<std::vector<std::byte>*>(to);
    bytes.insert(bytes.end(), first, first + size);
}

/// The file that `write` makes with what appends bytes to it.
EncodedPicture written(auto write) {
    std::vector<std::byte> bytes;
    if (write(&append_bytes, &bytes) != 0) return bytes;
    return std::unexpected(tr("memory is short"));
}

int channels_of(const RawPicture& picture) { return picture.alpha ? 4 : 3; }

}  // namespace

EncodedPicture encoded_jpeg(const RawPicture& picture, int quality) {
    return written([&](auto* append, void* to) {
        return stbi_write_jpg_to_func(append, to, picture.width, picture.height,
                                      channels_of(picture), picture.rows.data(), quality);
    });
}

EncodedPicture encoded_bmp(const RawPicture& picture) {
    return written([&](auto* append, void* to) {
        return stbi_write_bmp_to_func(append, to, picture.width, picture.height,
                                      channels_of(picture), picture.rows.data());
    });
}

EncodedPicture encoded_tga(const RawPicture& picture) {
    return written([&](auto* append, void* to) {
        return stbi_write_tga_to_func(append, to, picture.width, picture.height,
                                      channels_of(picture), picture.rows.data());
    });
}

EncodedPicture encoded_hdr(int width, int height, std::span<const float> light) {
    return written([&](auto* append, void* to) {
        return stbi_write_hdr_to_func(append, to, width, height, 3, light.data());
    });
}

}  // namespace zeroset
