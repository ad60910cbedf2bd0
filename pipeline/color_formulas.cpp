#include "pipeline/color_formulas.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/expr/patch_graph.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/differences/derivatives.hpp"
#include "engine/rewrite/stretch.hpp"
#include "jit/compile.hpp"
#include "pipeline/contour_step.hpp"
#include "pipeline/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zeroset {
namespace {

// LLVM takes about 0.1 ms for a node where only values are compiled.
constexpr std::size_t most_nodes_of_code = 4'000;

/// `missing`: the error where there is none.
std::expected<Expr, InputError> expression_of(const std::string& text, const RowProgram& rows,
                                              const char* missing) {
    if (trimmed(text).empty()) return wrong_input(missing);
    auto expression = read_value(text, rows.text, rows.program->parameters, rows.files.get());
    if (!expression) return std::unexpected(input_error(expression.error(), text));
    return std::move(*expression);
}

std::expected<Expr, InputError> color_expression(const ColorChoice& choice,
                                                 const RowProgram& rows) {
    return expression_of(choice.expression, rows,
                         tr("there is no expression to color by; type one such as x^2 + y^2"));
}

/// The expression that `by` shows for a surface f = 0.
Expr shape_of(ColorBy by, const Expr& f) {
    if (by == ColorBy::MeanCurvature) return mean_curvature(f);
    if (by == ColorBy::GaussianCurvature) return gaussian_curvature(f);
    return gradient_size(f);
}

PointFunction code_of(const Expr& expr) {
    if (expr.nodes().size() <= most_nodes_of_code) {
        if (auto code = jit::compile_points(expr)) return std::move(*code);
    }
    return interpret_points(expr);
}

SurfaceLines lines_of(const LineChoice& choice, const ColorFormulas& formulas, const glm::dvec3& up,
                      const Box& clip) {
    constexpr double lines_a_box = 20.0;
    SurfaceLines lines;
    if (choice.width) lines.width_px = static_cast<float>(*choice.width);
    lines.labels = choice.labels;
    lines.intersections = choice.intersections;
    switch (choice.contours) {
        case Contours::None: break;
        case Contours::Height: lines.contours = {{.along = up}}; break;
        case Contours::Coordinates:
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 along(0.0);
                along[axis] = 1.0 / formulas.stretch[axis];
                lines.contours.push_back({.along = along});
            }
            break;
        case Contours::Expression:
            // The last expression that could be read may still be another one.
            if (formulas.contours) lines.contours = {{.code = formulas.contours}};
            break;
    }
    const bool in_box = choice.contours != Contours::Expression;
    lines.step = choice.step.value_or(in_box ? even_step(clip.size() / lines_a_box * 1.5) : 1.0);
    return lines;
}

}  // namespace

std::expected<Expr, InputError> contour_expression(const LineChoice& lines,
                                                   const RowProgram& rows) {
    return expression_of(
        lines.expression, rows,
        tr("there is no expression for contour lines; type one such as x^2 + y^2"));
}

std::expected<ColorFormulas, InputError> color_formulas(const RowProgram& rows,
                                                        const ColorChoice& choice,
                                                        const glm::dvec3& stretch) {
    ColorFormulas formulas{.by = choice.by, .expression = choice.expression, .values = {}};
    formulas.stretch = stretch;
    if (choice.lines.contours == Contours::Expression) {
        const auto expression = contour_expression(choice.lines, rows);
        if (!expression) return std::unexpected(expression.error());
        formulas.contour_expression = choice.lines.expression;
        formulas.contours = code_of(stretched(*expression, stretch));
    }
    if (!has_formula(choice.by)) return formulas;
    if (choice.by == ColorBy::Expression) {
        const auto expression = color_expression(choice, rows);
        if (!expression) return std::unexpected(expression.error());
        formulas.values.assign(rows.program->surfaces.size(),
                               code_of(stretched(*expression, stretch)));
        return formulas;
    }
    if (std::ranges::any_of(rows.program->surfaces,
                            [](const Expr& surface) { return is_patch(surface); }))
        return wrong_input(
            tr("curvature and gradient are known of equations only: colour parametric surfaces by "
               "height, normal or an expression"));
    for (const Expr& surface : rows.program->surfaces)
        formulas.values.push_back(code_of(stretched(shape_of(choice.by, surface), stretch)));
    return formulas;
}

std::optional<InputError> check_coloring(const RowProgram& rows, const ColorChoice& choice) {
    if (choice.by != ColorBy::Expression) return std::nullopt;
    const auto expression = color_expression(choice, rows);
    return expression ? std::nullopt : std::optional(expression.error());
}

std::optional<InputError> check_contours(const RowProgram& rows, const LineChoice& lines) {
    if (lines.contours != Contours::Expression) return std::nullopt;
    const auto expression = contour_expression(lines, rows);
    return expression ? std::nullopt : std::optional(expression.error());
}

Coloring coloring_of(const ColorChoice& choice, const ColorFormulas& formulas,
                     const std::vector<std::size_t>& shown, const glm::dvec3& up, const Box& clip) {
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
    coloring.up[axis] = (up[axis] < 0.0 ? -1.0 : 1.0) / formulas.stretch[axis];
    coloring.lines = lines_of(choice.lines, formulas, coloring.up, clip);
    return coloring;
}

}  // namespace zeroset
