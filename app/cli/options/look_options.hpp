#pragma once

#include "document/look.hpp"
#include "pipeline/input_error.hpp"

#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// Options for colours and markers, as typed.
struct LookText {
    std::optional<std::string> color_by, color_range, color_map, contours;
    std::optional<bool> intersections;
    std::vector<std::string> marks;  ///< x,y,z of each
};

/// Applies the options to `coloring` and `markers`. Returns an error if an option is wrong;
/// expressions are checked later, by color_formulas.
std::optional<InputError> read_look(const LookText& text, ColorChoice& coloring,
                                    std::vector<Marker>& markers);

/// Reads the value of --contours into `lines`: none, height, xyz or an expression; then, each after
/// a ";", "step S" and "width W".
std::optional<InputError> read_contours(const std::string& text, LineChoice& lines);

/// Turns an error in the expression of the contours into "--contours: " with reason and place.
InputError contours_error(const InputError& error);

/// Turns an error in the expression into "--color-by EXPR: " with reason and place.
InputError color_by_error(const InputError& error);

}  // namespace zeroset
