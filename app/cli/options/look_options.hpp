#pragma once

#include "document/look.hpp"
#include "pipeline/input_error.hpp"

#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// What the user typed for colours and markers.
struct LookText {
    std::optional<std::string> color_by, color_range, color_map;
    std::vector<std::string> marks;  ///< x,y,z of each
};

/// Changes what the options say; what is wrong with them, if anything is. Whether an expression can
/// be read is for color_formulas.
std::optional<InputError> read_look(const LookText& text, ColorChoice& coloring,
                                    std::vector<Marker>& markers);

/// "--color-by EXPR: ", what is wrong with it, and where.
InputError color_by_error(const InputError& error);

}  // namespace zeroset
