#include "pipeline/color_formulas.hpp"

#include "engine/base/text.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/differences/derivatives.hpp"
#include "jit/compile.hpp"
#include "pipeline/input_error.hpp"

#include <cmath>
#include <utility>

namespace zeroset {
namespace {

// LLVM takes about 0.1 ms for a node where only values are compiled.
constexpr std::size_t most_nodes = 4'000;

std::expected<Expr, InputError> expression_of(const ColorChoice& choice, const RowProgram& rows) {
    if (trimmed(choice.expression).empty()) {
        return wrong_input("there is no expression to colour by; type one such as x^2 + y^2");
    }
    auto expression = read_value(choice.expression, rows.text, rows.program->parameters);
    if (!expression) return std::unexpected(input_error(expression.error(), choice.expression));
    return std::move(*expression);
}

/// The expression that `by` shows for a surface f = 0.
Expr shape_of(ColorBy by, const Expr& f) {
    if (by == ColorBy::MeanCurvature) return mean_curvature(f);
    if (by == ColorBy::GaussianCurvature) return gaussian_curvature(f);
    return gradient_size(f);
}

PointFunction code_of(const Expr& expr) {
    if (expr.nodes().size() <= most_nodes) {
        if (auto code = jit::compile_points(expr)) return std::move(*code);
    }
    return interpret_points(expr);
}

}  // namespace

std::expected<ColorFormulas, InputError> color_formulas(const RowProgram& rows,
                                                        const ColorChoice& choice) {
    ColorFormulas formulas{.by = choice.by, .expression = choice.expression, .values = {}};
    if (!has_formula(choice.by)) return formulas;
    if (choice.by == ColorBy::Expression) {
        const auto expression = expression_of(choice, rows);
        if (!expression) return std::unexpected(expression.error());
        formulas.values.assign(rows.program->surfaces.size(), code_of(*expression));
        return formulas;
    }
    for (const Expr& surface : rows.program->surfaces)
        formulas.values.push_back(code_of(shape_of(choice.by, surface)));
    return formulas;
}

std::optional<InputError> check_coloring(const RowProgram& rows, const ColorChoice& choice) {
    if (choice.by != ColorBy::Expression) return std::nullopt;
    const auto expression = expression_of(choice, rows);
    return expression ? std::nullopt : std::optional(expression.error());
}

Coloring coloring_of(const ColorChoice& choice, const ColorFormulas& formulas,
                     const std::vector<std::size_t>& shown, const glm::dvec3& up) {
    Coloring coloring;
    coloring.by = formulas.by;
    coloring.map = choice.map.value_or(usual_map(coloring.by));
    coloring.range = choice.range;
    for (const std::size_t surface : shown) {
        if (!formulas.values.empty()) coloring.values.push_back(formulas.values[surface]);
    }
    int axis = 2;
    for (const int other : {0, 1}) {
        if (std::abs(up[other]) > std::abs(up[axis])) axis = other;
    }
    coloring.up = glm::dvec3(0.0);
    coloring.up[axis] = up[axis] < 0.0 ? -1.0 : 1.0;
    return coloring;
}

}  // namespace zeroset
