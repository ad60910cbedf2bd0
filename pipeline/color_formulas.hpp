#pragma once

#include "document/look.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/scene/coloring.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/input_error.hpp"

#include <expected>
#include <string>
#include <vector>

namespace zeroset {

/// The functions behind the colours of a program's surfaces.
struct ColorFormulas {
    ColorBy by = ColorBy::Plain;
    std::string expression;
    std::vector<PointFunction> values;  ///< of each surface; empty unless has_formula(by)
};

/// Made for the surfaces as they were typed; `text` is that of the program. Machine code unless it
/// would take long. The error's column and offset are of the expression. Thread-safe.
std::expected<ColorFormulas, InputError> color_formulas(const Program& program,
                                                        const std::string& text,
                                                        const ColorChoice& choice);

/// How the choice colours a scene that shows those of the program's surfaces that are `shown`; the
/// heights are along the axis nearest to the camera's up.
Coloring coloring_of(const ColorChoice& choice, const ColorFormulas& formulas,
                     const std::vector<std::size_t>& shown, const glm::dvec3& up);

}  // namespace zeroset
