#include "engine/image/framebuffer.hpp"

#include <cmath>
#include <limits>

namespace zeroset {

Framebuffer::Framebuffer(int width_px, int height_px) : width(width_px), height(height_px) {
    const std::size_t pixels = index(0, height);
    color.resize(pixels);
    depth.resize(pixels, std::numeric_limits<float>::infinity());
    certificate.resize(pixels, Certificate::Miss);
    surface.resize(pixels, no_surface);
}

void Framebuffer::keep_planes(bool normals) {
    light.resize(color.size());
    normal.resize(normals ? color.size() : 0);
}

Framebuffer certificate_picture(const Framebuffer& frame) {
    constexpr std::uint32_t green = 0xFF52A83C;
    constexpr std::uint32_t teal = 0xFFA09A1E;
    constexpr std::uint32_t amber = 0xFF1FA9F2;
    constexpr std::uint32_t red = 0xFF3B3BE0;
    constexpr std::uint32_t violet = 0xFFD0659B;
    constexpr std::uint32_t black = 0xFF000000;
    Framebuffer picture = frame;
    picture.blank_rows.clear();
    for (std::size_t i = 0; i < picture.color.size(); ++i) {
        const bool drawn = std::isfinite(frame.depth[i]);
        switch (frame.certificate[i]) {
            case Certificate::Miss: picture.color[i] = black; break;
            case Certificate::Certified: picture.color[i] = green; break;
            case Certificate::Coarse: picture.color[i] = teal; break;
            case Certificate::Jump: picture.color[i] = violet; break;
            case Certificate::Undecided: picture.color[i] = drawn ? amber : red; break;
        }
    }
    return picture;
}

CertificateCounts count_certificates(const Framebuffer& frame) {
    CertificateCounts counts;
    for (std::size_t i = 0; i < frame.certificate.size(); ++i) {
        switch (frame.certificate[i]) {
            case Certificate::Miss: ++counts.miss; break;
            case Certificate::Certified: ++counts.certified; break;
            case Certificate::Coarse:
                ++counts.certified;
                ++counts.coarse;
                break;
            case Certificate::Jump: ++counts.jumps; break;
            case Certificate::Undecided:
                ++counts.undecided;
                if (!std::isfinite(frame.depth[i])) ++counts.not_drawn;
                break;
        }
    }
    return counts;
}

std::vector<std::size_t> count_surfaces(const Framebuffer& frame, std::size_t surfaces) {
    std::vector<std::size_t> counts(surfaces);
    for (const std::uint8_t surface : frame.surface) {
        if (surface < surfaces) ++counts[surface];
    }
    return counts;
}

}  // namespace zeroset
