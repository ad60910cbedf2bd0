#pragma once

#include "document/look.hpp"
#include "pipeline/input_error.hpp"

#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// Options for colours and markers, as typed.
struct LookText {
    std::optional<std::string> color_by, color_range, color_map;
    std::vector<std::string> marks;  ///< x,y,z of each
};

/// Applies the options to `coloring` and `markers`. Returns an error if an option is wrong;
/// expressions are checked later, by color_formulas.
std::optional<InputError> read_look(const LookText& text, ColorChoice& coloring,
                                    std::vector<Marker>& markers);

/// Turns an error in the expression into "--color-by EXPR: " with reason and place.
InputError color_by_error(const InputError& error);

}  // namespace zeroset
