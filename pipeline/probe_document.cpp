#include "pipeline/probe_document.hpp"

#include "engine/expr/patch_graph.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/scene/tolerance.hpp"

namespace zeroset {
std::vector<Kernel> typed_formulas(const Formula& formula, const std::vector<std::size_t>& shown) {
    const Program& program = *formula.program;
    std::vector<Kernel> formulas;
    formulas.reserve(shown.size());
    for (const std::size_t surface : shown)
        formulas.push_back(is_patch(program.surfaces[surface])
                               ? formula.kernels[surface]
                               : interpret(program.surfaces[surface]));
    return formulas;
}

double depth_tolerance(const Box& clip, const StopCriterion& stop, Precision precision) {
    constexpr double guess = 1e-3;  // part of the box's size
    return certified_width(clip, stop, precision).value_or(guess * clip.size());
}

}  // namespace zeroset
