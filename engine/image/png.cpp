#include "engine/image/png.hpp"

#include <stb/stb_image_write.h>

namespace zeroset {

std::vector<std::byte> encoded_png(const void* pixels, int width, int height, int channels) {
    std::vector<std::byte> bytes;
    const auto append = [](void* context, void* data, int size) {
        auto& out = *static_cast<std::vector<std::byte>*>(context);
        const auto* const begin = static_cast<const std::byte*>(data);
        out.insert(out.end(), begin, begin + size);
    };
    const int done =
        stbi_write_png_to_func(append, &bytes, width, height, channels, pixels, channels * width);
    return done == 0 ? std::vector<std::byte>() : bytes;
}

}  // namespace zeroset
