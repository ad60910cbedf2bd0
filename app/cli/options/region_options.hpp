#pragma once

#include "app/cli/options/options.hpp"
#include "engine/scene/region.hpp"
#include "pipeline/input_error.hpp"

namespace zeroset {

/// The region of the view options over `base`. `eye`: a section that says no side keeps the other
/// one.
OrInputError<Region> read_region(const ViewText& view, const Region& base, const glm::dvec3& eye);

}  // namespace zeroset
