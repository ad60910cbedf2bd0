#pragma once

#include "document/document.hpp"
#include "ui/model/edited.hpp"
#include "ui/model/shown.hpp"

#include <glm/ext/vector_double2.hpp>

#include <vector>

struct ImDrawList;
struct ImVec2;

namespace zeroset::ui {

/// Markers and the legend over the picture that is shown between `lo` and `hi` (window
/// coordinates).
void draw_picture_marks(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi,
                        const Edited& edited, const Shown& shown);

/// How exactly the place of a marker is told, in world units: so that neighbouring pixels differ,
/// or to about five digits where there is no picture yet.
double marker_resolution(const Marker& marker, const ShownPicture& picture);

/// The number of the marker under a cursor (see PointerMotion), no farther than `reach` in heights
/// of the picture; 0: none. Those behind surfaces do not count.
int marker_under(const std::vector<Marker>& markers, const ShownPicture& picture,
                 const ViewPoint& cursor, double reach);

}  // namespace zeroset::ui
