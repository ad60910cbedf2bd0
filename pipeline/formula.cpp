#include "pipeline/formula.hpp"

#include "engine/base/clock.hpp"
#include "engine/base/translation.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/stretch.hpp"
#include "engine/rewrite/surface_functions.hpp"
#include "engine/rewrite/traceable.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/patch_surface.hpp"
#include "pipeline/sample_region.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace zeroset {
namespace {

using Clock = std::chrono::steady_clock;

// LLVM takes 0.4 to 1 ms and 25 kB for each node.
constexpr std::size_t most_nodes_compiled = 8'000;

/// The first of the uniforms of a surface's thickness, among the parameters.
std::size_t thickness_at(const Formula& formula, std::size_t surface) {
    const auto place =
        std::ranges::find(formula.thick, surface, &ThickSurface::surface) - formula.thick.begin();
    return formula.program->parameters.size() +
           thickness_uniforms * static_cast<std::size_t>(place);
}

/// The surfaces that are drawn as f = 0.
std::vector<Expr> implicit_surfaces(const Formula& formula) {
    std::vector<Expr> surfaces;
    for (const Expr& surface : formula.drawn) {
        if (!is_patch(surface)) surfaces.push_back(surface);
    }
    return surfaces;
}

/// The kernels of all surfaces, from those of `implicit_surfaces`. Those of parametric surfaces
/// stay, if there are any.
std::vector<Kernel> with_patches(const Formula& formula, std::vector<Kernel> implicit) {
    std::vector<Kernel> kernels;
    auto next = implicit.begin();
    for (std::size_t i = 0; i < formula.drawn.size(); ++i) {
        if (!is_patch(formula.drawn[i])) {
            kernels.push_back(std::move(*next++));
            kernels.back().facts = formula.facts[i];
        } else if (i < formula.kernels.size()) {
            kernels.push_back(formula.kernels[i]);
        } else {
            kernels.push_back(patch_code(*patch_of(formula.drawn[i]), thickness_at(formula, i)));
        }
    }
    return kernels;
}

CodeState code_for(const std::vector<Expr>& surfaces, CodeUse use, Preparation how) {
    std::size_t nodes = 0;
    for (const Expr& surface : surfaces) {
        if (!has_many_choices(surface)) nodes += surface.nodes().size();
    }
    if (nodes > most_nodes_compiled) return CodeState::Interpreted;
    if (surfaces.empty()) return CodeState::Machine;
    if (how == Preparation::Compiled)
        return jit::can_compile() ? CodeState::Machine : CodeState::Interpreted;
    if (how == Preparation::Interpreted) return CodeState::InterpretedFirst;
    return is_compiled(surfaces, use) ? CodeState::Machine : CodeState::InterpretedFirst;
}

std::expected<std::vector<Kernel>, InputError> machine_code(const Formula& formula, CodeUse use,
                                                            Precision precision) {
    auto kernels = machine_code(implicit_surfaces(formula), formula.region, use, precision);
    if (!kernels)
        return wrong_input(
            filled(tr("the formula cannot be compiled: {0}"), {kernels.error().message}));
    return with_patches(formula, std::move(*kernels));
}

/// The facts known of a surface that is drawn as f = 0.
std::shared_ptr<const SurfaceFacts> found_facts(const Expr& f, bool is_sheet) {
    SurfaceFacts facts{.defined_everywhere = is_defined_everywhere(f), .is_sheet = is_sheet};
    if (const auto is = level_of_field(f))
        facts.field = {.field = is->field, .level = interpret(is->level).in_double.range};
    for (const Expr& witness : root_witnesses(f))
        facts.witnesses.push_back(interpret(witness).in_double.range);
    if (!facts.witnesses.empty()) {
        if (const auto domain = domain_witness(f))
            facts.domain = interpret(*domain).in_double.range;
    }
    return std::make_shared<const SurfaceFacts>(std::move(facts));
}

/// Returns the formula with the interpreter's code, which always evaluates in float and in double.
Formula interpreted(Formula formula) {
    std::vector<Kernel> kernels;
    for (const Expr& surface : implicit_surfaces(formula)) {
        Kernel& kernel = kernels.emplace_back(interpret(surface));
        // With few choices, finding out which can be left out takes longer than evaluating them.
        if (!has_many_choices(surface)) kernel.specializer = nullptr;
    }
    formula.kernels = with_patches(formula, std::move(kernels));
    return formula;
}

}  // namespace

bool Formula::uses_w() const { return std::ranges::any_of(kernels, &Kernel::uses_w); }

std::size_t Formula::nodes() const {
    std::size_t nodes = 0;
    for (const Expr& surface : drawn)
        nodes += surface.nodes().size();
    return nodes;
}

bool Formula::has_code(Precision precision) const {
    return precision == Precision::Float || std::ranges::all_of(kernels, &Kernel::has_double);
}

std::expected<Formula, InputError> prepare_formula(RowProgram rows, const FormulaPlace& place,
                                                   Preparation how) {
    const auto start = Clock::now();
    const CodeUse use = how == Preparation::Compiled ? CodeUse::Pictures : CodeUse::FirstPicture;
    Formula formula;
    static_cast<RowProgram&>(formula) = std::move(rows);
    formula.stretch = place.stretch;
    formula.region = stretched(place.region, place.stretch);
    for (const Expr& typed : formula.program->surfaces) {
        const std::size_t index = formula.drawn.size();
        const Expr shown = stretched(typed, place.stretch);
        if (const auto graphs = patch_of(typed)) {
            if (has_thickness(graphs->kind))
                formula.thick.push_back({.surface = index, .kind = graphs->kind});
            if (graphs->kind == PatchKind::Point)
                formula.points.push_back({.surface = index, .graphs = *graphs});
        }
        const Expr surface = drawn_formula(shown, thickness_at(formula, index));
        formula.section_values.push_back(is_patch(shown) ? PointFunction()
                                                         : interpret_points(value_side(shown)));
        if (is_patch(surface)) {
            formula.drawn.push_back(surface);
            formula.facts.emplace_back();
            formula.unrestricted.emplace_back();
            continue;
        }
        const Expr& drawn =
            formula.drawn.emplace_back(traceable(surface, sample_region(formula.region)));
        formula.facts.push_back(found_facts(drawn, formula.program->sheets[index]));
        const auto whole = unrestricted(drawn);
        auto& value = formula.unrestricted.emplace_back();
        if (whole) value = interpret(*whole).in_float.value;
    }
    formula.code = code_for(implicit_surfaces(formula), use, how);
    if (formula.code != CodeState::Machine) {
        formula = interpreted(std::move(formula));
    } else {
        auto kernels = machine_code(formula, use, Precision::Float);
        if (!kernels) return std::unexpected(kernels.error());
        formula.kernels = std::move(*kernels);
    }
    formula.compile_ms = ms_since(start);
    return formula;
}

std::expected<Formula, InputError> with_machine_code(const Formula& formula, CodeUse use,
                                                     Precision precision) {
    const auto start = Clock::now();
    Formula result = formula;
    if (!implicit_surfaces(formula).empty() && !jit::can_compile()) {
        result.code = CodeState::Interpreted;
        return result;
    }
    auto kernels = machine_code(formula, use, precision);
    if (!kernels) return std::unexpected(kernels.error());
    result.kernels = std::move(*kernels);
    result.code = CodeState::Machine;
    result.compile_ms += ms_since(start);
    return result;
}

Formula with_double(const Formula& formula) {
    if (auto result = with_machine_code(formula, CodeUse::FirstPicture, Precision::Double))
        return std::move(*result);
    return interpreted(formula);
}

bool has_many_choices(const Formula& formula) {
    return std::ranges::any_of(formula.drawn,
                               [](const Expr& surface) { return has_many_choices(surface); });
}

bool is_made_of_parts(const Formula& formula) {
    return std::ranges::any_of(formula.drawn, [&](const Expr& surface) {
        return is_made_of_parts(surface, formula.region);
    });
}

double steps_left(const Formula& formula) {
    double steps = 0;
    for (std::size_t i = 0; i < formula.drawn.size(); ++i)
        steps += steps_left(formula.drawn[i], formula.kernels[i], formula.region);
    return steps;
}

std::string note_on_code(const Formula& formula) {
    if (formula.code != CodeState::Interpreted) return {};
    return jit::missing_code().value_or("large: interpreted");
}

bool is_preview(const Formula& formula) {
    constexpr std::size_t most_nodes_soon = 300;
    return formula.code == CodeState::InterpretedFirst && formula.nodes() <= most_nodes_soon;
}

}  // namespace zeroset
