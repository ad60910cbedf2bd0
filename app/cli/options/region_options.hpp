#pragma once

#include "app/cli/options/options.hpp"
#include "engine/scene/region.hpp"
#include "pipeline/input_error.hpp"

namespace zeroset {

/// Applies the view options to the region `base`. For a section without a side, the side away from
/// `eye` is kept.
OrInputError<Region> read_region(const ViewText& view, const Region& base, const glm::dvec3& eye);

/// Reads the box that an option gives: L for [-L, L]^3, or x0,x1,y0,y1,z0,z1.
OrInputError<Box> read_box(const std::string& option, const std::string& text);

}  // namespace zeroset
