#pragma once

#include "ui/style/theme.hpp"

#include <glm/glm.hpp>

namespace zeroset::ui {

/// Draws a ball of this diameter (window coordinates), lit from `towards`: to the right, upwards
/// and out of the screen, not 0. A drag over the ball aims it; beyond the rim, at what is behind; a
/// right click takes it to the other side. Returns true when it was moved.
bool draw_light_ball(const char* id, glm::dvec3& towards, float size, const Palette& colors);

}  // namespace zeroset::ui
