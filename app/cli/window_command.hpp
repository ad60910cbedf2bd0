#pragma once

#include "app/cli/options/options.hpp"
#include "app/desktop/desktop.hpp"
#include "pipeline/input_error.hpp"

#include <string>

namespace zeroset {

/// The gallery's first surface where `equation` is empty; a d_stop for interaction where no stop is
/// given. The formula may have errors: the window shows them.
OrInputError<DesktopOptions> read_desktop_options(const std::string& equation, const ViewText& view,
                                                  const TraceText& trace);

}  // namespace zeroset
