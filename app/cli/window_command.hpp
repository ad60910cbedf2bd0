#pragma once

#include "app/cli/options/options.hpp"
#include "app/desktop/desktop.hpp"
#include "pipeline/input_error.hpp"

#include <cstdint>
#include <string>

namespace zeroset {

/// What becomes of a text that cannot be read. Rows of a file may always have errors: the window
/// shows them.
enum class TextErrors : std::uint8_t { Shown, Refused };

/// Options of the window for EQUATION; the gallery's first surface where it is empty.
OrInputError<DesktopOptions> read_desktop_options(const std::string& equation, const ViewText& view,
                                                  const TraceText& trace,
                                                  TextErrors errors = TextErrors::Shown);

}  // namespace zeroset
