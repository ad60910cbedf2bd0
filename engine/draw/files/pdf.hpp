#pragma once

#include "engine/draw/files/drawing_style.hpp"

#include <expected>
#include <string>

namespace zeroset {

/// The drawing as a PDF of one page of its size, with true curves; or the reason why it cannot be
/// made.
std::expected<std::string, std::string> pdf_of(const LineDrawing& drawing,
                                               const DrawingStyle& style);

}  // namespace zeroset
