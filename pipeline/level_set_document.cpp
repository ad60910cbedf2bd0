#include "pipeline/level_set_document.hpp"

#include "engine/base/translation.hpp"
#include "engine/rewrite/surface_functions.hpp"
#include "engine/trace/caps.hpp"
#include "pipeline/mesh_solid.hpp"
#include "pipeline/patch_surface.hpp"

#include <utility>

namespace zeroset {
namespace {

/// The colour of a surface alone, whatever its points are coloured by.
MeshColor color_of(Scene scene, std::size_t surface) {
    scene.coloring.by = ColorBy::Plain;
    MeshObject object;
    color_object(scene, surface, {}, object);
    return object.color;
}

}  // namespace

OrInputError<LevelSetFile> level_sets_of(const PictureRequest& request, double size_mm,
                                         std::optional<std::size_t> surface) {
    auto refused = patch_refusal(
        request, tr("an implicit function is made of equations, not of parametric surfaces, curves "
                    "and points: hide their rows"));
    if (refused) return std::unexpected(std::move(*refused));
    const Scene scene = scene_of(request);
    LevelSetFile file{.surfaces = {},
                      .lo = request.clip.lo,
                      .hi = request.clip.hi,
                      .values = request.uniforms,
                      .mm_per_unit = size_mm / request.clip.size()};
    for (const Section& section : request.region.sections)
        file.planes.push_back({.normal = section.normal, .offset = section.offset});
    if (const auto& ball = request.region.ball)
        file.balls.push_back({.centre = ball->centre, .radius = ball->radius});
    for (std::size_t i = 0; i < request.surfaces.size(); ++i) {
        const std::size_t index = request.surfaces[i].index;
        if (surface && *surface != index + 1) continue;
        RestrictedExpr restricted = without_restriction(request.formula->program->surfaces[index]);
        const std::string& text = request.formula->surface_texts[index];
        file.comment.push_back(std::to_string(index + 1) + ": " + text);
        file.surfaces.push_back({.name = text,
                                 .function = std::move(restricted.function),
                                 .side = solid_sign(scene, i) > 0 ? -1.0 : 1.0,
                                 .bounds = std::move(restricted.bounds),
                                 .color = color_of(scene, i)});
    }
    if (file.surfaces.empty())
        return wrong_input(tr("there is no surface that is shown: show a row of the list"));
    return file;
}

OrInputError<EncodedLevelSets> encoded_level_sets_of(const PictureRequest& request, double size_mm,
                                                     std::optional<std::size_t> surface) {
    const auto file = level_sets_of(request, size_mm, surface);
    if (!file) return std::unexpected(file.error());
    auto encoded = encode_level_sets(*file);
    if (!encoded) return wrong_input(std::move(encoded.error()));
    return std::move(*encoded);
}

}  // namespace zeroset
