#include "pipeline/probe_document.hpp"

#include "engine/expr/patch_graph.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/differences/derivatives.hpp"
#include "engine/rewrite/stretch.hpp"
#include "engine/scene/tolerance.hpp"

#include <glm/glm.hpp>

#include <algorithm>

namespace zeroset {

std::vector<Kernel> typed_formulas(const Program& program, const Formula* formula,
                                   const std::vector<std::size_t>& shown) {
    std::vector<Kernel> formulas;
    formulas.reserve(shown.size());
    for (const std::size_t surface : shown) {
        if (!is_patch(program.surfaces[surface])) {
            const glm::dvec3 stretch = formula == nullptr ? glm::dvec3(1.0) : formula->stretch;
            formulas.push_back(interpret(stretched(program.surfaces[surface], stretch)));
        } else {
            formulas.push_back(formula == nullptr ? Kernel() : formula->kernels[surface]);
        }
    }
    return formulas;
}

PointFacts unstretched(PointFacts facts, const glm::dvec3& stretch) {
    facts.point /= stretch;
    facts.within /= std::min({stretch.x, stretch.y, stretch.z});  // along any ray
    if (facts.normal != glm::dvec3(0.0)) facts.normal = glm::normalize(stretch * facts.normal);
    return facts;
}

double depth_tolerance(const Box& clip, const StopCriterion& stop, Precision precision) {
    constexpr double guess = 1e-3;  // part of the box's size
    return certified_width(clip, stop, precision).value_or(guess * clip.size());
}

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
