#include "engine/measure/wrong_pixels.hpp"

#include "engine/view/pixel_ray.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

enum class Fault : std::uint8_t { None, Missed, Added, Moved };

/// The distance along a ray for a step of 1 along its dominant axis.
double stretch_of(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    return glm::length(direction) / std::max({size.x, size.y, size.z});
}

/// Looks at pixels one by one.
class Judge {
public:
    Judge(const Framebuffer& frame, const Framebuffer& proved, const Camera& camera,
          double tolerance)
        : frame_(frame),
          proved_(proved),
          view_(camera),
          image_{.width = frame.width, .height = frame.height},
          tolerance_(tolerance) {}

    [[nodiscard]] Fault fault_of(int col, int row) const {
        const std::size_t i = frame_.index(col, row);
        const bool is_shown = std::isfinite(frame_.depth[i]);
        if (proved_.certificate[i] == Certificate::Miss)
            return is_shown ? Fault::Added : Fault::None;
        if (!is_proved(proved_.certificate[i])) return Fault::None;
        if (!is_shown) return Fault::Missed;
        const auto depth = static_cast<double>(proved_.depth[i]);
        const double rounding = 0x1p-20 * (std::abs(depth) + glm::length(view_.eye));
        const double allowed =
            tolerance_ * stretch_of(view_.direction(pixel_centre(col, row), image_)) + rounding;
        const bool near = std::abs(static_cast<double>(frame_.depth[i]) - depth) <= allowed;
        return near ? Fault::None : Fault::Moved;
    }

    /// Calls `visit(col, row, fault)` with all pixels that have one.
    void visit_faults(auto&& visit) const {
        for (int row = 0; row < frame_.height; ++row) {
            for (int col = 0; col < frame_.width; ++col) {
                const Fault fault = fault_of(col, row);
                if (fault != Fault::None) visit(col, row, fault);
            }
        }
    }

private:
    const Framebuffer& frame_;
    const Framebuffer& proved_;
    ViewFrame view_;
    ImageSize image_;
    double tolerance_;
};

constexpr std::uint32_t opaque = 0xFF000000U;

/// A grey half as bright.
std::uint32_t dimmed(std::uint32_t color) {
    const std::uint32_t sum = (color & 0xFFU) + (color >> 8U & 0xFFU) + (color >> 16U & 0xFFU);
    return opaque | sum / 6 * 0x010101U;
}

std::uint32_t color_of(Fault fault) {
    switch (fault) {
        case Fault::Missed: return 0xFF3B3BF0;
        case Fault::Added: return 0xFFE065B0;
        case Fault::Moved: return 0xFF1FA9F2;
        case Fault::None: break;
    }
    return opaque;
}

}  // namespace

WrongPixels wrong_pixels(const Framebuffer& frame, const Framebuffer& proved, const Camera& camera,
                         double tolerance) {
    WrongPixels wrong;
    const Judge judge(frame, proved, camera, tolerance);
    judge.visit_faults([&](int col, int row, Fault fault) {
        const Certificate claim = frame.certificate[frame.index(col, row)];
        switch (fault) {
            case Fault::Missed: ++wrong.missed; break;
            case Fault::Added: ++wrong.added; break;
            case Fault::Moved: ++wrong.moved; break;
            case Fault::None: break;
        }
        const bool claims = fault == Fault::Missed ? claim == Certificate::Miss : is_proved(claim);
        wrong.refuted += claims ? 1 : 0;
    });
    return wrong;
}

std::vector<std::uint32_t> difference_colors(const Framebuffer& frame, const Framebuffer& proved,
                                             const Camera& camera, double tolerance) {
    std::vector<std::uint32_t> colors;
    colors.reserve(frame.color.size());
    for (const std::uint32_t color : frame.color)
        colors.push_back(dimmed(color));
    const Judge judge(frame, proved, camera, tolerance);
    judge.visit_faults([&](int col, int row, Fault fault) {
        for (int r = std::max(row - 1, 0); r <= std::min(row + 1, frame.height - 1); ++r) {
            for (int c = std::max(col - 1, 0); c <= std::min(col + 1, frame.width - 1); ++c)
                colors[frame.index(c, r)] = color_of(fault);
        }
    });
    return colors;
}

}  // namespace zeroset
