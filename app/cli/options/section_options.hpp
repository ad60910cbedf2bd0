#pragma once

#include "app/cli/options/options.hpp"
#include "document/look.hpp"
#include "engine/scene/region.hpp"
#include "pipeline/input_error.hpp"

#include <optional>

namespace zeroset {

/// Applies the options of what sections show to those of the region and to the values' choice.
std::optional<InputError> read_section_looks(const ViewText& view, Region& region,
                                             SectionChoice& values);

}  // namespace zeroset
