#include "ui/window/texture.hpp"

#include "engine/image/background.hpp"
#include "engine/image/blend.hpp"
#include "engine/image/frame_pictures.hpp"
#include "engine/image/framebuffer.hpp"
#include "ui/window/gl.hpp"

#include <GL/gl.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset::ui {
namespace {

/// True on diagonal stripes that are half of the period wide.
bool is_on_stripe(std::size_t pixel, int width) {
    constexpr std::size_t period_px = 8;
    const auto columns = static_cast<std::size_t>(width);
    return (pixel % columns + pixel / columns) % period_px < period_px / 2;
}

}  // namespace

Texture::Texture() {
    gl().gen_textures(1, &name_);
    gl().bind_texture(GL_TEXTURE_2D, name_);
    gl().tex_parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl().tex_parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    set_filter(Filter::Linear);
}

Texture::~Texture() { gl().delete_textures(1, &name_); }

void Texture::upload(const Framebuffer& frame, std::uint32_t behind,
                     const std::optional<Tint>& tint) {
    if (!frame.cost.empty()) {
        pixels_ = cost_colors(frame);
        return upload(pixels_, frame.width, frame.height);
    }
    constexpr std::uint32_t opaque = 0xFF000000U;
    pixels_.resize(frame.color.size());
    const auto columns = static_cast<std::size_t>(frame.width);
    // One that was chosen is shown; else the window's own takes its place.
    const bool own_background = frame.background != Background();
    backgrounds_.clear();
    for (int row = 0; row < frame.height; ++row)
        backgrounds_.push_back(background_color(frame.background, row, frame.height));
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const bool drawn = std::isfinite(frame.depth[i]);
        const std::uint32_t color = frame.color[i];
        pixels_[i] = own_background           ? color | opaque
                     : is_partly_drawn(color) ? without_background(color, backgrounds_[i / columns])
                     : drawn                  ? color | opaque
                                              : behind & ~opaque;
        if (!tint) continue;
        const bool striped = drawn && !is_on_stripe(i, frame.width);
        if (frame.certificate[i] == Certificate::Undecided) {
            pixels_[i] = (striped ? tint->pale : tint->solid) | opaque;
        } else if (frame.certificate[i] == Certificate::Coarse && !striped) {
            pixels_[i] = tint->coarse | opaque;
        }
    }
    upload(pixels_, frame.width, frame.height);
}

void Texture::upload(const RgbaImage& image) { upload(image.pixels, image.width, image.height); }

void Texture::upload(const std::vector<std::uint32_t>& pixels, int width, int height) {
    gl().bind_texture(GL_TEXTURE_2D, name_);
    gl().pixel_store(GL_UNPACK_ALIGNMENT, 4);
    if (width == width_ && height == height_) {
        gl().tex_sub_image(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE,
                           pixels.data());
        return;
    }
    width_ = width;
    height_ = height;
    gl().tex_image(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                   pixels.data());
}

void Texture::set_filter(Filter filter) const {
    const GLint value = filter == Filter::Nearest ? GL_NEAREST : GL_LINEAR;
    gl().bind_texture(GL_TEXTURE_2D, name_);
    gl().tex_parameter(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, value);
    gl().tex_parameter(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, value);
}

}  // namespace zeroset::ui
