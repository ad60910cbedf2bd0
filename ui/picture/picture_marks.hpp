#pragma once

#include "document/look.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/view/camera.hpp"
#include "ui/style/theme.hpp"

#include <glm/ext/vector_double2.hpp>

#include <span>

struct ImDrawList;
struct ImVec2;

namespace zeroset::ui {

/// Markers in a picture.
struct MarkedPicture {
    std::span<const Marker> markers;
    const Framebuffer& frame;
    const Camera& camera;  ///< that the picture was taken with
    int selected = 0;      ///< number of the marker that shows its coordinates, too; 0: none
};

/// Dots with their numbers, faint behind surfaces. (lo, hi): the picture's area, window
/// coordinates.
void draw_markers(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi,
                  const MarkedPicture& picture, const Palette& colors);

/// The number of the marker under a cursor (see PointerMotion), no farther than `reach` in heights
/// of the picture; 0: none. Those behind surfaces do not count.
int marker_under(const MarkedPicture& picture, const glm::dvec2& cursor, double reach);

/// Whether a surface hides a point.
bool is_behind(const Framebuffer& frame, const ViewFrame& view, const glm::dvec3& point);

}  // namespace zeroset::ui
