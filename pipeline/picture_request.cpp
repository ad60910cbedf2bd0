#include "pipeline/picture_request.hpp"

#include "document/colors.hpp"
#include "document/framing.hpp"
#include "engine/base/translation.hpp"
#include "engine/render/tracers.hpp"
#include "engine/scene/precision.hpp"
#include "engine/trace/caps.hpp"
#include "engine/trace/ways/surface_ways.hpp"
#include "pipeline/contour_step.hpp"
#include "pipeline/patch_surface.hpp"
#include "pipeline/section_values.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {

namespace {

/// The row of a surface; nullptr: none.
const Statement* row_of(const Document& document, const Formula& formula, std::size_t surface) {
    const auto row =
        std::ranges::find(document.statements, formula.surface_rows[surface], &Statement::id);
    return row == document.statements.end() ? nullptr : &*row;
}

/// Returns the surfaces whose rows are visible.
std::vector<ShownSurface> visible_surfaces(const Document& document, const Formula& formula) {
    const Program& program = *formula.program;
    std::vector<ShownSurface> shown;
    for (std::size_t i = 0; i < formula.surface_rows.size(); ++i) {
        const Statement* const row = row_of(document, formula, i);
        if (row == nullptr || !row->visible) continue;
        SolidSide side = row->solid;
        if (side == SolidSide::Automatic && program.solids[i]) side = SolidSide::Below;
        shown.push_back({.index = i,
                         .row = row->id,
                         .color = row->color,
                         .solid = side,
                         .look = {.look = row->look, .opacity = row->opacity},
                         .thickness = row->thickness});
    }
    return shown;
}

/// Gives the outsides of solids the colours of fronts, however their equations are written. Without
/// a solid, the front is where f > 0.
void turn_fronts_out(Scene& scene) {
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        SurfaceColors& colors = *scene.surfaces[i].colors;
        if (solid_sign(scene, i) > 0) std::swap(colors.front, colors.back);
    }
}

}  // namespace

PictureRequest picture_request(std::shared_ptr<const Formula> formula,
                               std::shared_ptr<const ColorFormulas> colors,
                               const Document& document, const TraceSettings& settings,
                               glm::ivec2 size_px) {
    PictureRequest request{
        .formula = std::move(formula),
        .colors = std::move(colors),
        .clip = document.clip,
        .region = document.region,
        .camera = {},
        .coloring = document.coloring,
        .section_values = document.section_values,
        .light = document.light,
        .jumps = document.jumps,
        .settings = settings,
        .size_px = size_px,
        .surfaces = {},
        .uniforms = {},
    };
    request.camera =
        camera_of(document, static_cast<double>(size_px.x) / size_px.y, request.formula->stretch);
    request.settings.shadows = document.shadows;
    request.settings.antialias = document.antialias;
    request.settings.reflections = document.light.reflections;
    request.surfaces = visible_surfaces(document, *request.formula);
    request.uniforms.push_back(request.formula->uses_w() ? document.w.value : 0.0);
    for (const std::string& name : request.formula->program->parameters)
        request.uniforms.push_back(slider_of(document, name).value);
    return request;
}

Camera camera_of(const Document& document, glm::ivec2 size_px) {
    return camera_of(document, static_cast<double>(size_px.x) / size_px.y);
}

bool differs_in_code_only(const PictureRequest& last, const PictureRequest& next) {
    if (!same_functions(*last.formula, *next.formula)) return false;
    PictureRequest by_new_code = last;
    by_new_code.formula = next.formula;
    by_new_code.colors = next.colors;
    return by_new_code == next;
}

std::vector<std::size_t> shown_indices(const PictureRequest& request) {
    std::vector<std::size_t> indices;
    indices.reserve(request.surfaces.size());
    for (const ShownSurface& surface : request.surfaces)
        indices.push_back(surface.index);
    return indices;
}

std::vector<double> uniform_values(const PictureRequest& request) {
    std::vector<double> values = request.uniforms;
    for (const auto& [surface, kind] : request.formula->thick) {
        const auto shown = std::ranges::find(request.surfaces, surface, &ShownSurface::index);
        const ThicknessUniforms thickness = thickness_of(
            kind, shown != request.surfaces.end() ? shown->thickness : std::nullopt,
            stretched(request.clip, request.formula->stretch), request.camera, request.size_px.y);
        values.insert(values.end(), thickness.begin(), thickness.end());
    }
    return values;
}

Uniforms uniforms_of(const PictureRequest& request) {
    const std::vector<double> values = uniform_values(request);
    Uniforms uniforms;
    for (std::size_t i = 0; i < values.size(); ++i)
        uniforms.set(i, values[i]);
    return uniforms;
}

namespace {

/// The surfaces where they are shown, without what they look like.
Scene bare_scene(const PictureRequest& request) {
    Scene scene;
    scene.clip = stretched(request.clip, request.formula->stretch);
    scene.region = stretched(request.region, request.formula->stretch);
    scene.jumps = request.jumps;
    scene.uniforms = uniforms_of(request);
    for (const ShownSurface& surface : request.surfaces)
        scene.surfaces.push_back({.kernel = request.formula->kernels[surface.index]});
    return scene;
}

/// The scene with fronts where f > 0.
Scene scene_as_written(const PictureRequest& request) {
    const Formula& formula = *request.formula;
    Scene scene = bare_scene(request);
    scene.lighting = {.look = request.light.look,
                      .lights = request.light.lights,
                      .absorption = request.light.absorption,
                      .tone = request.light.tone};
    scene.background = request.light.background.value_or(Background());
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        const ShownSurface& shown = request.surfaces[i];
        Surface& surface = scene.surfaces[i];
        surface.colors = shown.color ? surface_colors(*shown.color) : colors_of(shown.index);
        surface.look = shown.look;
        surface.solid = {.side = shown.solid, .unrestricted = formula.unrestricted[shown.index]};
        surface.section_value = formula.section_values[shown.index];
    }
    scene.coloring = coloring_of(request.coloring, *request.colors, shown_indices(request),
                                 request.camera.up, request.clip);
    SurfaceLines& lines = scene.coloring.lines;
    const bool leaves_step = !request.coloring.lines.step && !lines.contours.empty();
    if (leaves_step && lines.contours.front().code)
        lines.step = contour_step(scene, lines.contours.front().code);
    return scene;
}

/// Lets all tracers read the formulas of the surfaces that are shown.
void let_read_formulas(const PictureRequest& request) {
    const Formula& formula = *request.formula;
    for (const Tracer& tracer : tracers()) {
        if (tracer.needs.read_formula == nullptr) continue;
        for (const std::size_t surface : shown_indices(request))
            tracer.needs.read_formula(formula.kernels[surface], formula.drawn[surface],
                                      formula.code == CodeState::Machine);
    }
}

}  // namespace

Scene scene_of(const PictureRequest& request) {
    let_read_formulas(request);
    Scene scene = scene_as_written(request);
    turn_fronts_out(scene);
    scene.section_values = section_values(request.section_values, scene);
    return scene;
}

RenderRequest render_request(const PictureRequest& request) {
    RenderRequest frame;
    frame.scene = scene_of(request);
    frame.camera = request.camera;
    frame.settings = request.settings;
    frame.width = request.size_px.x;
    frame.height = request.size_px.y;
    return frame;
}

bool has_code_for(const PictureRequest& request) {
    const ViewFrame view(request.camera);
    return request.formula->has_code(
        wanted_precision(bare_scene(request), view, request.settings.stop));
}

void add_needed_code(PictureRequest& request) {
    if (!has_code_for(request))
        request.formula = std::make_shared<const Formula>(with_double(*request.formula));
}

std::optional<std::string> tracer_refusal(std::string_view tracer, std::string_view name,
                                          const PictureRequest& request) {
    const Tracer* const found = find_tracer(tracer);
    if (found == nullptr || !request.formula) return std::nullopt;
    for (const std::size_t surface : shown_indices(request)) {
        const Kernel& kernel = request.formula->kernels[surface];
        if (!found->takes_ways && !way_of(kernel).is_level_set()) {
            return std::string(name) + ": " +
                   tr("draws equations alone; for parametric surfaces, curves and points choose "
                      "beams");
        }
        if (found->needs.refuses == nullptr) continue;
        if (const char* const reason = found->needs.refuses(kernel))
            return std::string(name) + ": " + tr(reason);
    }
    return std::nullopt;
}

}  // namespace zeroset
