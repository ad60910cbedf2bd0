#pragma once

#include "engine/image/framebuffer.hpp"
#include "ui/model/ui_state.hpp"

#include <functional>

struct ImDrawList;

namespace zeroset::ui {

/// Draws on a finished picture as the panels are drawn on the window, by the processor alone: no
/// window and no OpenGL is needed. `draw` gets a canvas of the picture's size in pixels, on which
/// fonts and em() are those of a window at `scale`. Not while a Window is alive.
void draw_over(Framebuffer& picture, float scale, Theme theme,
               const std::function<void(ImDrawList&)>& draw);

/// What the window draws over its picture, for one of its own (see draw_over): markers and, unless
/// it is nullptr, a legend.
void draw_marks_over(Framebuffer& picture, const Camera& camera, const std::vector<Marker>& markers,
                     const Legend* legend);

}  // namespace zeroset::ui
