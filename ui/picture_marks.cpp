#include "ui/picture_marks.hpp"

#include "engine/trace/pixel_ray.hpp"
#include "ui/fonts.hpp"
#include "ui/picture_place.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace zeroset::ui {
namespace {

constexpr float radius_em = 0.32F;

/// The opacity of a colour times that.
std::uint32_t faded(std::uint32_t color, float opacity) {
    const auto alpha = static_cast<float>(color >> 24U) * opacity;
    return (color & 0x00FFFFFFU) | static_cast<std::uint32_t>(alpha + 0.5F) << 24U;
}

/// Where a point shows in the area.
struct Area {
    ImVec2 lo, hi;

    [[nodiscard]] ImVec2 at(const glm::dvec2& place) const {
        const float height = hi.y - lo.y;
        return {0.5F * (lo.x + hi.x) + static_cast<float>(place.x) * height,
                0.5F * (lo.y + hi.y) - static_cast<float>(place.y) * height};
    }
    [[nodiscard]] bool holds(const ImVec2& p) const {
        return p.x >= lo.x && p.x < hi.x && p.y >= lo.y && p.y < hi.y;
    }
};

/// How far apart neighbouring pixels are at a distance: what a marker's coordinates need.
double resolution_at(const ViewFrame& view, const Framebuffer& frame, double distance) {
    return 0.1 * view.pixel_width(std::max(frame.height, 1), distance);
}

/// A tag beside the dot, at the left of it where it would leave the area.
void draw_tag(ImDrawList& canvas, const Area& area, const ImVec2& dot, const std::string& text,
              float opacity, const Palette& colors) {
    ImFont* const small = font(FontRole::Small);
    const float size = small->FontSize * ImGui::GetIO().FontGlobalScale;
    const ImVec2 extent = small->CalcTextSizeA(size, 1e9F, 0.0F, text.c_str());
    const float gap = em(radius_em + 0.3F);
    const float pad = em(0.3F);
    const bool fits = dot.x + gap + extent.x + 2.0F * pad <= area.hi.x;
    const float width = extent.x + 2.0F * pad;
    const float wished = fits ? dot.x + gap : dot.x - gap - width;
    const float left = std::max(std::min(wished, area.hi.x - width), area.lo.x);
    const float low = area.lo.y + extent.y;
    const float top = std::clamp(dot.y - gap, low, std::max(low, area.hi.y)) - extent.y;
    canvas.AddRectFilled(ImVec2(left, top), ImVec2(left + extent.x + 2.0F * pad, top + extent.y),
                         faded(colors.card, opacity), em(0.3F));
    canvas.AddText(small, size, ImVec2(left + pad, top), faded(colors.text, opacity), text.c_str());
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
    const Area area{lo, hi};
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
        draw_tag(canvas, area, dot, text, hidden ? 0.55F : 1.0F, colors);
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
