#include "pipeline/drawing_scene.hpp"

#include "document/framing.hpp"
#include "engine/base/translation.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/volume/volume.hpp"
#include "jit/compile.hpp"
#include "pipeline/color_formulas.hpp"
#include "pipeline/drawing_marks.hpp"
#include "pipeline/fit_view.hpp"
#include "pipeline/patch_surface.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"

#include <glm/ext/vector_int2.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace zeroset {
namespace {

double aspect_of(const PageSize& page) { return page.width / page.height; }

/// The document with the camera of a picture of the page's aspect.
Document with_camera(Document document, const PageSize& page) {
    if (!document.camera) document.camera = camera_of(document, aspect_of(page));
    return document;
}

PictureRequest request_for(const Document& document, const PreparedDocument& prepared,
                           const PageSize& page) {
    const glm::ivec2 size(static_cast<int>(std::ceil(page.width)),
                          static_cast<int>(std::ceil(page.height)));
    return picture_request(prepared.formula, prepared.colors, document, {}, size);
}

/// The axis of a coordinate, or nothing for other directions.
std::optional<int> axis_of(const glm::dvec3& along) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(along[axis]) == 1.0) return axis;
    }
    return std::nullopt;
}

/// The numbers whose contour lines the document shows.
std::expected<std::vector<ContourNumber>, InputError> contour_numbers(const Document& document,
                                                                      const RowProgram& rows,
                                                                      const SurfaceLines& lines) {
    std::vector<ContourNumber> numbers;
    if (document.coloring.lines.contours == Contours::Expression) {
        auto formula = contour_expression(document.coloring.lines, rows);
        if (!formula) return std::unexpected(formula.error());
        numbers.push_back({.axis = std::nullopt, .formula = std::move(*formula)});
        return numbers;
    }
    for (const PointNumber& number : lines.contours)
        numbers.push_back({.axis = axis_of(number.along)});
    return numbers;
}

/// The code of a function of curves: machine code where that is soon made and often called.
Kernel kernel_of(const Expr& f) {
    constexpr std::size_t most_nodes = 4'000;
    constexpr std::size_t most_thorough_nodes = 200;
    // Items that the interpreter evaluates in about the time that LLVM takes for them.
    constexpr std::size_t patience = 15'000;
    const std::size_t nodes = f.nodes().size();
    if (nodes > most_nodes) return interpret(f);
    return jit::compile_when_called(
        f, {.hasty = nodes > most_thorough_nodes, .patient_nodes = patience * nodes});
}

/// Whether a volume that is interpolated linearly is among the functions of f.
bool has_linear_volume(const Expr& f) {
    return std::ranges::any_of(f.nodes(), [](const Node& node) {
        const auto* const volume = dynamic_cast<const Volume*>(node.field.get());
        return volume != nullptr && volume->spline() == nullptr;
    });
}

}  // namespace

std::expected<DrawingScene, InputError> drawing_scene(Document document, RowProgram rows,
                                                      const DrawingChoice& choice,
                                                      const TimeLimit& limit) {
    auto prepared = prepare(document, std::move(rows), Preparation::Compiled);
    if (!prepared) return std::unexpected(prepared.error());
    document = with_camera(std::move(document), choice.page);
    DrawingScene result;
    result.page = choice.page;
    if (choice.fits) {
        result.note = fit_view(document, request_for(document, *prepared, choice.page),
                               aspect_of(choice.page), choice.fits_box, limit);
    } else if (choice.fits_itself) {
        result.note = fit_by_itself(document, request_for(document, *prepared, choice.page),
                                    aspect_of(choice.page), own_fitting_limit(limit));
    }
    const PictureRequest request = request_for(document, *prepared, choice.page);
    auto refused = patch_refusal(
        request, tr("a line drawing shows equations, not yet parametric surfaces, curves and "
                    "points: hide their rows, or save a picture"));
    if (refused) return std::unexpected(std::move(*refused));
    result.scene = scene_of(request);
    result.camera = request.camera.in_drawn_world();
    for (const std::size_t i : shown_indices(request))
        result.surfaces.push_back(prepared->formula->drawn[i]);
    auto numbers = contour_numbers(document, *prepared->formula, result.scene.coloring.lines);
    if (!numbers) return std::unexpected(numbers.error());
    result.options = {.kinds = choice.kinds,
                      .contours = std::move(*numbers),
                      .contour_step = result.scene.coloring.lines.step,
                      .contour_width_pt = document.coloring.lines.width,
                      .hidden = choice.hidden,
                      .tolerance_pt = choice.tolerance_pt};
    result.marks = drawing_marks(document, request, choice.page, limit);
    return result;
}

LineDrawing line_drawing(const DrawingScene& scene, const TimeLimit& limit, const OnPath& on_path) {
    const DrawnScene input{.scene = scene.scene,
                           .surfaces = scene.surfaces,
                           .camera = scene.camera,
                           .page = scene.page,
                           .make_kernel = kernel_of};
    LineDrawing drawing = draw_scene(input, scene.options, limit, on_path);
    drawing.marks = scene.marks;
    drawing.has_linear_volume = std::ranges::any_of(scene.surfaces, has_linear_volume);
    return drawing;
}

}  // namespace zeroset
