#include "pipeline/probe_document.hpp"

#include "engine/expr/patch_graph.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/scene/tolerance.hpp"

namespace zeroset {
std::vector<Kernel> typed_formulas(const Program& program, const Formula* formula,
                                   const std::vector<std::size_t>& shown) {
    std::vector<Kernel> formulas;
    formulas.reserve(shown.size());
    for (const std::size_t surface : shown) {
        if (!is_patch(program.surfaces[surface])) {
            formulas.push_back(interpret(program.surfaces[surface]));
        } else {
            formulas.push_back(formula == nullptr ? Kernel() : formula->kernels[surface]);
        }
    }
    return formulas;
}

double depth_tolerance(const Box& clip, const StopCriterion& stop, Precision precision) {
    constexpr double guess = 1e-3;  // part of the box's size
    return certified_width(clip, stop, precision).value_or(guess * clip.size());
}

}  // namespace zeroset
