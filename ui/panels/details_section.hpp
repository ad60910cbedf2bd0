#pragma once

#include "engine/scene/settings.hpp"
#include "ui/model/shown.hpp"

#include <string>

namespace zeroset::ui {

/// The search depth, and the figures of the last full picture: its time and size, how many pixels
/// are certified and how many undecided, how wide the view is and in what precision it was traced.
void draw_details_section(StopCriterion& stop, const Shown& shown);
/// Height of the section's contents in window coordinates.
float details_section_height(const Shown& shown);

/// True where so many pixels are undecided that a person who looks at the picture should know.
bool many_undecided(const PictureFigures& figures);

/// "1 234 undecided, 7 of them not drawn".
std::string undecided_text(const PictureFigures& figures);
/// "12.5 ms".
std::string frame_time(double ms);

}  // namespace zeroset::ui
