#include "ui/picture/picture_marks.hpp"

#include "engine/view/pixel_ray.hpp"
#include "ui/picture/picture_place.hpp"
#include "ui/picture/picture_tag.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace zeroset::ui {
namespace {

constexpr float radius_em = 0.32F;

/// How far apart neighbouring pixels are at a distance: what a marker's coordinates need.
double resolution_at(const ViewFrame& view, const Framebuffer& frame, double distance) {
    return 0.1 * view.pixel_width(std::max(frame.height, 1), distance);
}

void draw_dot(ImDrawList& canvas, const ImVec2& at, bool hidden, bool selected,
              const Palette& colors) {
    const float radius = em(radius_em);
    const float opacity = hidden ? 0.45F : 1.0F;
    if (!hidden) canvas.AddCircleFilled(at, radius, colors.accent, 24);
    canvas.AddCircle(at, radius, faded(hidden ? colors.accent : 0xFFFFFFFFU, opacity), 24,
                     em(0.12F));
    canvas.AddCircle(at, radius + em(0.1F), faded(0xFF000000U, 0.5F * opacity), 24, em(0.07F));
    if (selected) canvas.AddCircle(at, radius + em(0.3F), colors.accent, 32, em(0.12F));
}

}  // namespace

bool is_behind(const Framebuffer& frame, const ViewFrame& view, const glm::dvec3& point) {
    const auto seen = place_in_view(view, point);
    if (!seen) return true;
    const glm::ivec2 pixel = pixel_under(frame, seen->place);
    // On the surface itself a pixel's centre is as near as the point, but for its slant.
    float farthest = 0.0F;
    for (int row = std::max(pixel.y - 1, 0); row <= std::min(pixel.y + 1, frame.height - 1);
         ++row) {
        for (int col = std::max(pixel.x - 1, 0); col <= std::min(pixel.x + 1, frame.width - 1);
             ++col)
            farthest = std::max(farthest, frame.depth[frame.index(col, row)]);
    }
    constexpr double slack = 1.0 + 1e-4;
    return seen->distance > slack * static_cast<double>(farthest);
}

void draw_markers(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi,
                  const MarkedPicture& picture, const Palette& colors) {
    const ViewFrame view(picture.camera);
    const PictureArea area{lo, hi};
    for (const Marker& marker : picture.markers) {
        const auto seen = place_in_view(view, marker.at);
        if (!seen) continue;
        const ImVec2 dot = area.at(seen->place);
        if (!area.holds(dot)) continue;
        const bool hidden = is_behind(picture.frame, view, marker.at);
        const bool selected = marker.number == picture.selected;
        draw_dot(canvas, dot, hidden, selected, colors);
        std::string text = std::to_string(marker.number);
        if (selected) {
            text += "  " +
                    coordinates_text(marker.at, resolution_at(view, picture.frame, seen->distance));
        }
        draw_tag(canvas, area, dot, em(radius_em + 0.3F), text, hidden ? 0.55F : 1.0F, colors);
    }
}

int marker_under(const MarkedPicture& picture, const glm::dvec2& cursor, double reach) {
    const ViewFrame view(picture.camera);
    int nearest = 0;
    for (const Marker& marker : picture.markers) {
        const auto seen = place_in_view(view, marker.at);
        if (!seen || is_behind(picture.frame, view, marker.at)) continue;
        const double off = std::hypot(seen->place.x - cursor.x, seen->place.y - cursor.y);
        if (off > reach) continue;
        reach = off;
        nearest = marker.number;
    }
    return nearest;
}

}  // namespace zeroset::ui
