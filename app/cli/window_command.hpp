#pragma once

#include "app/cli/options/options.hpp"
#include "app/desktop/desktop.hpp"
#include "pipeline/input_error.hpp"

#include <cstdint>
#include <string>

namespace zeroset {

/// Whether a text that cannot be read is an error. Rows of a file may always have errors, which the
/// window shows.
enum class TextErrors : std::uint8_t { Shown, Refused };

/// Options of the window for EQUATION, or for the gallery's first surface if EQUATION is empty.
OrInputError<DesktopOptions> read_desktop_options(const std::string& equation, const ViewText& view,
                                                  const TraceText& trace,
                                                  TextErrors errors = TextErrors::Shown);

}  // namespace zeroset
