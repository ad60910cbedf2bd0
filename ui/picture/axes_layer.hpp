#pragma once

#include "ui/model/edited.hpp"
#include "ui/model/shown.hpp"

struct ImDrawList;
struct ImVec2;

namespace zeroset::ui {

/// Axes, clip box and grid, as far as they are wanted, over the picture that is shown between `lo`
/// and `hi` (window coordinates).
void draw_axes(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi, const Edited& edited,
               const ShownPicture& picture);

}  // namespace zeroset::ui
