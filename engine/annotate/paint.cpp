#include "engine/annotate/paint.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {

std::uint32_t blended(std::uint32_t under, std::uint32_t over, double coverage) {
    constexpr std::uint32_t one = 1U << 16U;
    const double opacity = coverage * static_cast<double>(over >> 24U) / 255.0;
    const double before = (1.0 - opacity) * static_cast<double>(under >> 24U) / 255.0;
    if (!(opacity + before > 0.0)) return under;
    const auto part = static_cast<std::uint32_t>(opacity / (opacity + before) * one);
    std::uint32_t mixed = static_cast<std::uint32_t>((opacity + before) * 255.0 + 0.5) << 24U;
    for (const unsigned shift : {0U, 8U, 16U}) {
        const std::uint32_t from = under >> shift & 0xFFU;
        const std::uint32_t to = over >> shift & 0xFFU;
        mixed |= (from * (one - part) + to * part + one / 2) / one << shift;
    }
    return mixed;
}

void paint_line(Framebuffer& picture, const glm::dvec2& from, const glm::dvec2& to, double width,
                std::uint32_t color) {
    const double length = glm::distance(from, to);
    if (!(length > 0)) return;
    picture.blank_rows.clear();
    const glm::dvec2 along = (to - from) / length;
    const int major = std::abs(along.x) >= std::abs(along.y) ? 0 : 1;
    const int minor = 1 - major;
    const int size[2] = {picture.width, picture.height};
    // The line reaches so many pixels along the minor axis, at each place of it.
    const double reach = (0.5 * width + 1.0) / std::abs(along[major]);
    const auto clamped = [](double at, int end) {
        return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(end)));
    };
    const int first = clamped(std::min(from[major], to[major]) - 1.0, size[major]);
    const int last = clamped(std::max(from[major], to[major]) + 2.0, size[major]);
    for (int i = first; i < last; ++i) {
        const double t = (i + 0.5 - from[major]) / along[major];
        const double middle = from[minor] + t * along[minor];
        const int lo = clamped(std::floor(middle - reach), size[minor]);
        const int hi = clamped(std::ceil(middle + reach), size[minor]);
        for (int j = lo; j < hi; ++j) {
            glm::dvec2 pixel;
            pixel[major] = i + 0.5;
            pixel[minor] = j + 0.5;
            const glm::dvec2 offset = pixel - from;
            const double place = glm::dot(offset, along);
            if (place < 0 || place >= length) continue;
            const double distance = std::abs(along.x * offset.y - along.y * offset.x);
            const double coverage =
                std::clamp(0.5 * width + 0.5 - distance, 0.0, std::min(width, 1.0));
            const std::size_t at = picture.index(major == 0 ? i : j, major == 0 ? j : i);
            if (coverage > 0) picture.color[at] = blended(picture.color[at], color, coverage);
        }
    }
}

}  // namespace zeroset
