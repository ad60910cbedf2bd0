#include "ui/widgets/light_ball.hpp"

#include "ui/style/label.hpp"

#include <glm/gtc/constants.hpp>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace zeroset::ui {
namespace {

std::uint32_t gray(double light) {
    const auto level = static_cast<std::uint32_t>(255.0 * std::sqrt(std::clamp(light, 0.0, 1.0)));
    return 0xFF000000U | level << 16U | level << 8U | level;
}

/// The lit ball, as a mesh of rings and sectors that is coloured at its corners.
void draw_ball(ImDrawList& canvas, const ImVec2& centre, float radius, const glm::dvec3& light) {
    constexpr int rings = 10;
    constexpr int sectors = 32;
    constexpr int triangles = sectors * (2 * rings - 1);
    const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
    canvas.PrimReserve(3 * triangles, 1 + rings * sectors);
    const auto first = canvas._VtxCurrentIdx;
    const auto write = [&](double x, double y) {
        const glm::dvec3 normal(x, y, std::sqrt(std::max(1.0 - x * x - y * y, 0.0)));
        canvas.PrimWriteVtx(ImVec2(centre.x + radius * static_cast<float>(x),
                                   centre.y - radius * static_cast<float>(y)),
                            uv, gray(0.08 + 0.75 * std::max(glm::dot(normal, light), 0.0)));
    };
    write(0.0, 0.0);
    for (int ring = 1; ring <= rings; ++ring) {
        for (int sector = 0; sector < sectors; ++sector) {
            const double angle = 2.0 * glm::pi<double>() * sector / sectors;
            const double out = static_cast<double>(ring) / rings;
            write(out * std::cos(angle), out * std::sin(angle));
        }
    }
    // Corner 0 is the middle, then come those of each ring.
    const auto corner = [&](int ring, int sector) {
        const int at = ring == 0 ? 0 : 1 + (ring - 1) * sectors + sector % sectors;
        return static_cast<ImDrawIdx>(first + static_cast<unsigned>(at));
    };
    const auto triangle = [&](ImDrawIdx a, ImDrawIdx b, ImDrawIdx c) {
        for (const ImDrawIdx at : {a, b, c})
            canvas.PrimWriteIdx(at);
    };
    for (int ring = 1; ring <= rings; ++ring) {
        for (int sector = 0; sector < sectors; ++sector) {
            triangle(corner(ring - 1, sector), corner(ring, sector), corner(ring, sector + 1));
            if (ring > 1)
                triangle(corner(ring - 1, sector), corner(ring, sector + 1),
                         corner(ring - 1, sector + 1));
        }
    }
}

/// The direction that a place means, in radii from the ball's middle: beyond the rim it goes on
/// around the ball.
glm::dvec3 direction_at(double x, double y, bool in_front) {
    const double radius = std::hypot(x, y);
    if (radius <= 1.0) {
        const double depth = std::sqrt(std::max(1.0 - radius * radius, 0.0));
        return {x, y, in_front ? depth : -depth};
    }
    const double across = std::max(2.0 - radius, 0.0);
    const double depth = std::sqrt(1.0 - across * across);
    return {x / radius * across, y / radius * across, in_front ? -depth : depth};
}

}  // namespace

bool draw_light_ball(const char* id, glm::dvec3& towards, float size, const Palette& colors) {
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(id, ImVec2(size, size));
    draw_focus_ring();
    const float radius = 0.5F * size - em(0.15F);
    const ImVec2 centre(lo.x + 0.5F * size, lo.y + 0.5F * size);
    bool moved = false;
    if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        // The side on which the drag began, kept while it goes on.
        bool& in_front = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("front"), true);
        if (ImGui::IsItemActivated()) in_front = towards.z >= 0.0;
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const glm::dvec3 aimed =
            direction_at(static_cast<double>((mouse.x - centre.x) / radius),
                         static_cast<double>((centre.y - mouse.y) / radius), in_front);
        moved = aimed != towards;
        towards = aimed;
    } else if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        towards.z = towards.z == 0.0 ? -1e-3 : -towards.z;
        moved = true;
    }
    const glm::dvec3 light = glm::normalize(towards);
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    draw_ball(canvas, centre, radius, light);
    canvas.AddCircle(centre, radius - em(0.08F),
                     ImGui::IsItemHovered() ? colors.accent : colors.border, 48, em(0.1F));
    const ImVec2 at(centre.x + radius * static_cast<float>(light.x),
                    centre.y - radius * static_cast<float>(light.y));
    if (light.z >= 0.0) {
        canvas.AddCircleFilled(at, em(0.3F), colors.accent, 16);
    } else {
        canvas.AddCircle(at, em(0.3F), colors.accent, 16, em(0.12F));
    }
    return moved;
}

}  // namespace zeroset::ui
