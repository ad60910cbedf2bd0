#include "engine/image/framebuffer.hpp"

#include <limits>

namespace zeroset {

Framebuffer::Framebuffer(int width_px, int height_px) : width(width_px), height(height_px) {
    const std::size_t pixels = index(0, height);
    color.resize(pixels);
    depth.resize(pixels, std::numeric_limits<float>::infinity());
    certificate.resize(pixels, Certificate::Miss);
    surface.resize(pixels, no_surface);
}

CertificateCounts count_certificates(const Framebuffer& frame) {
    CertificateCounts counts;
    for (const Certificate certificate : frame.certificate) {
        switch (certificate) {
            case Certificate::Miss: ++counts.miss; break;
            case Certificate::Certified: ++counts.certified; break;
            case Certificate::Undecided: ++counts.undecided; break;
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
