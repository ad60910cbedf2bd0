#pragma once

#include "document/look.hpp"
#include "document/row_program.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/scene/coloring.hpp"
#include "pipeline/input_error.hpp"

#include <expected>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// The functions behind the colours of a program's surfaces.
struct ColorFormulas {
    ColorBy by = ColorBy::Plain;
    std::string expression;
    std::vector<PointFunction> values;  ///< of each surface; empty unless has_formula(by)
};

/// Makes them for the surfaces as they were typed. Machine code unless it would take long. The
/// error's column and offset are of the expression. Thread-safe.
std::expected<ColorFormulas, InputError> color_formulas(const RowProgram& rows,
                                                        const ColorChoice& choice);

/// The error that color_formulas would give.
std::optional<InputError> check_coloring(const RowProgram& rows, const ColorChoice& choice);

/// How the choice colours a scene that shows those of the program's surfaces that are `shown`; the
/// heights are along the axis nearest to the camera's up.
Coloring coloring_of(const ColorChoice& choice, const ColorFormulas& formulas,
                     const std::vector<std::size_t>& shown, const glm::dvec3& up);

}  // namespace zeroset
