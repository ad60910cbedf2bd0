#include "ui/texture.hpp"

#include "engine/image/framebuffer.hpp"

#include <GL/gl.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset::ui {

Texture::Texture() {
    glGenTextures(1, &name_);
    glBindTexture(GL_TEXTURE_2D, name_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    set_filter(Filter::Linear);
}

Texture::~Texture() { glDeleteTextures(1, &name_); }

void Texture::upload(const Framebuffer& frame, std::uint32_t behind) {
    constexpr std::uint32_t opaque = 0xFF000000U;
    pixels_.resize(frame.color.size());
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const bool drawn = std::isfinite(frame.depth[i]);
        pixels_[i] = drawn ? frame.color[i] | opaque : behind & ~opaque;
    }
    glBindTexture(GL_TEXTURE_2D, name_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    if (frame.width == width_ && frame.height == height_) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE,
                        pixels_.data());
        return;
    }
    width_ = frame.width;
    height_ = frame.height;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels_.data());
}

void Texture::set_filter(Filter filter) const {
    const GLint value = filter == Filter::Nearest ? GL_NEAREST : GL_LINEAR;
    glBindTexture(GL_TEXTURE_2D, name_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, value);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, value);
}

}  // namespace zeroset::ui
