#pragma once

#include "document/document.hpp"
#include "engine/scene/region.hpp"

namespace zeroset::ui {

/// The number of axes, and that of any other direction.
inline constexpr int free_axis = 3;

/// Returns the axis that the section is perpendicular to: 0 to 2, or free_axis.
int axis_of(const Section& section);

/// Returns a section perpendicular to `axis` through the box's centre or, for free_axis,
/// perpendicular to the view through the point looked at. It keeps the side away from the eye.
Section section_across(int axis, const Document& document);

/// Adds a section across an axis, another one each time; there must be fewer than max_sections.
void add_section(Document& document);

}  // namespace zeroset::ui
