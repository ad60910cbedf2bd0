#pragma once

#include "document/look.hpp"
#include "document/row_program.hpp"
#include "engine/expr/expr.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/scene/coloring.hpp"
#include "pipeline/input_error.hpp"

#include <expected>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// The functions that colour a program's surfaces.
struct ColorFormulas {
    ColorBy by = ColorBy::Plain;
    std::string expression;
    std::vector<PointFunction> values;  ///< one for each surface; empty unless has_formula(by)
    std::string contour_expression = {};
    PointFunction contours = {};  ///< of Contours::Expression
    glm::dvec3 stretch{1.0};      ///< of the world in which they are
};

/// Makes the functions for the surfaces as they were typed, in machine code unless that would take
/// long, in a world that is drawn stretched (Camera). An error's column and offset refer to the
/// expression. Thread-safe.
std::expected<ColorFormulas, InputError> color_formulas(
    const RowProgram& rows, const ColorChoice& choice, const glm::dvec3& stretch = glm::dvec3(1.0));

/// Returns the error that color_formulas would give, if any.
std::optional<InputError> check_coloring(const RowProgram& rows, const ColorChoice& choice);
/// Returns the error in the expression of the contour lines, if any.
std::optional<InputError> check_contours(const RowProgram& rows, const LineChoice& lines);

/// Reads the expression of the contour lines.
std::expected<Expr, InputError> contour_expression(const LineChoice& lines, const RowProgram& rows);

/// Colours a scene by the choice. `shown`: indices of the program's surfaces in the scene. Heights
/// are measured along the axis nearest to `up`, the camera's up; `clip` is the box that was typed.
/// The step of an expression's contour lines is 1 where the choice leaves it open.
Coloring coloring_of(const ColorChoice& choice, const ColorFormulas& formulas,
                     const std::vector<std::size_t>& shown, const glm::dvec3& up, const Box& clip);

}  // namespace zeroset
