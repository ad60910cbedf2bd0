#pragma once

#include "app/cli/options/options.hpp"
#include "engine/scene/region.hpp"
#include "pipeline/input_error.hpp"

namespace zeroset {

/// Applies the view options to the region `base`. For a section without a side, the side away from
/// `eye` is kept.
OrInputError<Region> read_region(const ViewText& view, const Region& base, const glm::dvec3& eye);

}  // namespace zeroset
