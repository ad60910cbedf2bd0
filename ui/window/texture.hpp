#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/image/rgba_image.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace zeroset::ui {

enum class Filter : std::uint8_t { Nearest, Linear };

/// A picture as an OpenGL texture. Lives while the window's context is current; window's thread.
class Texture {
public:
    /// Colours of uncertain pixels, as in Palette. Undecided pixels: `solid` where nothing is
    /// drawn, stripes of `solid` and `pale` where a surface is. Certified pixels with a coarse
    /// bracket: stripes of `coarse`.
    struct Tint {
        std::uint32_t solid;
        std::uint32_t pale;
        std::uint32_t coarse;
    };

    Texture();
    ~Texture();
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    /// Uploads a frame. Missed pixels, and the missed parts of smoothed ones, become transparent,
    /// so that the theme's background shows through. Missed pixels get the colour `behind` (as in
    /// Palette), so that a scaled picture has no fringe. A frame that keeps costs is shown by their
    /// colours alone (engine/image/frame_pictures.hpp).
    void upload(const Framebuffer& frame, std::uint32_t behind,
                const std::optional<Tint>& tint = std::nullopt);
    void upload(const RgbaImage& image);
    void set_filter(Filter filter) const;

    /// OpenGL's name of the texture.
    [[nodiscard]] unsigned int name() const { return name_; }
    /// Width in pixels; 0 before the first upload.
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

private:
    void upload(const std::vector<std::uint32_t>& pixels, int width, int height);

    unsigned int name_ = 0;
    int width_ = 0;
    int height_ = 0;
    std::vector<std::uint32_t> pixels_;
    std::vector<std::uint32_t> backgrounds_;  ///< background colour of each row of the frame
};

}  // namespace zeroset::ui
