#include "pipeline/snap_point.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/differences/derivatives.hpp"

#include <glm/glm.hpp>

namespace zeroset {

DerivedFormula derived_formula(const Expr& f) {
    const std::array<Expr, 3> slopes = gradient_of(f);
    return {.f = interpret(f),
            .slopes = {interpret(slopes[0]), interpret(slopes[1]), interpret(slopes[2])}};
}

std::optional<SpecialPoint> special_point_of(const PictureRequest& picture, const glm::dvec3& from,
                                             const glm::dvec3& up) {
    const Uniforms uniforms = uniforms_of(picture);
    const SpecialSearch search{
        .from = from, .up = up, .clip = picture.clip, .region = picture.region};
    std::optional<SpecialPoint> best;
    for (const std::size_t surface : shown_indices(picture)) {
        const auto found = nearest_special_point(
            derived_formula(picture.formula->program->surfaces[surface]), uniforms, search);
        if (!found) continue;
        if (!best || glm::distance(found->at, from) < glm::distance(best->at, from)) best = found;
    }
    return best;
}

}  // namespace zeroset
