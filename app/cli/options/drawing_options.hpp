#pragma once

#include "engine/draw/files/drawing_style.hpp"
#include "pipeline/drawing_scene.hpp"
#include "pipeline/input_error.hpp"

#include <optional>
#include <string>

namespace zeroset {

/// Options for drawings in lines, as typed.
struct DrawingText {
    std::string size = "400x400";
    std::optional<std::string> lines, hidden, width, tolerance, background;
};

struct DrawingPlan {
    DrawingChoice choice;
    DrawingStyle style;
};
/// Reads the options; `choice.fits` is left alone.
OrInputError<DrawingPlan> read_drawing(const DrawingText& text);

/// Reads "WxH" in points, or with pt, mm, cm or in behind it; each side 10 to 10000 points.
OrInputError<PageSize> read_page_size(const std::string& text);

}  // namespace zeroset
