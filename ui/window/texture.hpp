#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/image/rgba_image.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace zeroset::ui {

enum class Filter : std::uint8_t { Nearest, Linear };

/// A picture as an OpenGL texture. Lives while the window's OpenGL context is current; the
/// window's thread.
class Texture {
public:
    /// Colours for undecided pixels, as in Palette: `solid` where nothing is drawn, stripes of both
    /// where something is; and of the stripes over certified ones with a coarse bracket.
    struct Tint {
        std::uint32_t solid;
        std::uint32_t pale;
        std::uint32_t coarse;
    };

    Texture();
    ~Texture();
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    /// Missed pixels (and parts of smoothed ones) become transparent, so that the theme's
    /// background shows through them; they keep the colour `behind` (as in Palette) so that a
    /// stretched picture has no fringe.
    void upload(const Framebuffer& frame, std::uint32_t behind,
                const std::optional<Tint>& tint = std::nullopt);
    void upload(const RgbaImage& image);
    void set_filter(Filter filter) const;

    /// OpenGL's name of it.
    [[nodiscard]] unsigned int name() const { return name_; }
    /// In pixels; 0 before the first upload.
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

private:
    void upload(const std::vector<std::uint32_t>& pixels, int width, int height);

    unsigned int name_ = 0;
    int width_ = 0;
    int height_ = 0;
    std::vector<std::uint32_t> pixels_;
    std::vector<std::uint32_t> backgrounds_;  ///< of the frame's rows
};

}  // namespace zeroset::ui
