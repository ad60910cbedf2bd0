#include "pipeline/formula.hpp"

#include "engine/base/clock.hpp"
#include "engine/base/text.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/drawn_form.hpp"
#include "engine/rewrite/root_witnesses.hpp"
#include "engine/rewrite/unrestricted.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/sample_region.hpp"

#include <algorithm>
#include <chrono>

namespace zeroset {
namespace {

using Clock = std::chrono::steady_clock;

// LLVM takes 0.4 to 1 ms and 25 kB for a node.
constexpr std::size_t most_nodes = 8'000;

/// When a formula is interpreted at first.
enum class Interpreted : std::uint8_t { Never, UnlessCompiled, Always };

CodeState code_for(const std::vector<Expr>& surfaces, CodeUse use, Interpreted first) {
    std::size_t nodes = 0;
    for (const Expr& surface : surfaces) {
        if (!has_many_choices(surface)) nodes += surface.nodes().size();
    }
    if (nodes > most_nodes) return CodeState::Interpreted;
    if (first == Interpreted::Never) return CodeState::Machine;
    if (first == Interpreted::Always) return CodeState::InterpretedFirst;
    return is_compiled(surfaces, use) ? CodeState::Machine : CodeState::InterpretedFirst;
}

std::expected<std::vector<Kernel>, InputError> machine_code(const Formula& formula, CodeUse use,
                                                            Precision precision) {
    auto kernels = machine_code(formula.drawn, formula.region, use, precision);
    if (!kernels) return wrong_input("the formula cannot be compiled: " + kernels.error().message);
    return std::move(*kernels);
}

/// Adds what the kernels of the drawn surfaces know of their functions' zeros.
void add_witnesses(Formula& formula) {
    for (std::size_t i = 0; i < formula.drawn.size(); ++i) {
        Kernel& kernel = formula.kernels[i];
        for (const Expr& witness : root_witnesses(formula.drawn[i]))
            kernel.witnesses.push_back(interpret(witness).range_double);
        kernel.defined_everywhere = is_defined_everywhere(formula.drawn[i]);
        if (kernel.witnesses.empty()) continue;
        if (const auto domain = domain_witness(formula.drawn[i]))
            kernel.domain = interpret(*domain).range_double;
    }
}

/// The formula with the interpreter's code, which is always in both types.
Formula interpreted(Formula formula) {
    formula.kernels.clear();
    for (const Expr& surface : formula.drawn) {
        Kernel& kernel = formula.kernels.emplace_back(interpret(surface));
        // To find what can be left out of few choices takes longer than they do.
        if (!has_many_choices(surface)) kernel.specializer = nullptr;
    }
    add_witnesses(formula);
    return formula;
}

std::expected<Formula, InputError> prepared(std::string_view text, Program program,
                                            const Box& region, CodeUse use, Interpreted first,
                                            Clock::time_point start) {
    Formula formula{.text = std::string(text), .program = std::move(program), .region = region};
    for (const Expr& surface : formula.program.surfaces) {
        const Expr& drawn = formula.drawn.emplace_back(drawn_form(surface, sample_region(region)));
        const auto whole = unrestricted(drawn);
        auto& value = formula.unrestricted.emplace_back();
        if (whole) value = interpret(*whole).value_float;
    }
    formula.code = code_for(formula.drawn, use, first);
    if (formula.code != CodeState::Machine) {
        formula = interpreted(std::move(formula));
    } else {
        auto kernels = machine_code(formula, use, Precision::Float);
        if (!kernels) return std::unexpected(kernels.error());
        formula.kernels = std::move(*kernels);
        add_witnesses(formula);
    }
    formula.compile_ms = ms_since(start);
    return formula;
}

std::expected<Formula, InputError> prepared(std::string_view text, const Box& region, CodeUse use,
                                            Interpreted first) {
    const auto start = Clock::now();
    auto program = read_formula(text);
    if (!program) return std::unexpected(program.error());
    return prepared(text, std::move(*program), region, use, first, start);
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

std::expected<Program, InputError> read_formula(std::string_view text) {
    auto program = read_program(text);
    if (!program) return std::unexpected(input_error(program.error(), text));
    return std::move(*program);
}

std::expected<Formula, InputError> prepare_formula(std::string_view text, const Box& region) {
    return prepared(text, region, CodeUse::FirstPicture, Interpreted::UnlessCompiled);
}

std::expected<Formula, InputError> prepare_formula(std::string_view text, Program program,
                                                   const Box& region) {
    return prepared(text, std::move(program), region, CodeUse::FirstPicture,
                    Interpreted::UnlessCompiled, Clock::now());
}

std::expected<Formula, InputError> interpreted_formula(std::string_view text, const Box& region) {
    return prepared(text, region, CodeUse::FirstPicture, Interpreted::Always);
}

std::expected<Formula, InputError> with_machine_code(const Formula& formula, CodeUse use,
                                                     Precision precision) {
    const auto start = Clock::now();
    auto kernels = machine_code(formula, use, precision);
    if (!kernels) return std::unexpected(kernels.error());
    Formula result = formula;
    for (std::size_t i = 0; i < kernels->size(); ++i) {
        (*kernels)[i].witnesses = formula.kernels[i].witnesses;
        (*kernels)[i].defined_everywhere = formula.kernels[i].defined_everywhere;
        (*kernels)[i].domain = formula.kernels[i].domain;
    }
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

std::expected<Formula, InputError> compile_formula(std::string_view text, const Box& region,
                                                   Precision precision) {
    auto formula = prepared(text, region, CodeUse::Pictures, Interpreted::Never);
    if (!formula || formula->code == CodeState::Interpreted || formula->has_code(precision))
        return formula;
    return with_machine_code(*formula, CodeUse::Pictures, precision);
}

bool is_preview(const Formula& formula) {
    constexpr std::size_t most_nodes_soon = 300;
    return formula.code == CodeState::InterpretedFirst && formula.nodes() <= most_nodes_soon;
}

Scene make_scene(const Formula& formula, const Box& clip, double w,
                 const ParameterValues& parameters) {
    Scene scene{formula.kernels, clip, {}};
    for (const auto& unrestricted : formula.unrestricted)
        scene.solids.push_back({SolidSide::Automatic, unrestricted});
    scene.uniforms.set(0, w);
    const std::vector<double> values = values_of(formula.program, parameters);
    for (std::size_t i = 0; i < values.size(); ++i)
        scene.uniforms.set(1 + i, values[i]);
    return scene;
}

std::vector<double> values_of(const Program& program, const ParameterValues& parameters) {
    std::vector<double> values;
    for (const std::string& name : program.parameters) {
        const auto found = parameters.find(name);
        values.push_back(found == parameters.end() ? 1.0 : found->second);
    }
    return values;
}

std::optional<InputError> check_parameters(const Program& program,
                                           const ParameterValues& parameters) {
    for (const auto& [name, value] : parameters) {
        if (std::ranges::find(program.parameters, name) != program.parameters.end()) continue;
        std::string known = "the formula has none";
        if (!program.parameters.empty()) {
            known = "the formula's are";
            for (const std::string& parameter : program.parameters)
                known += " " + parameter;
        }
        return InputError{"--set " + name + ": there is no such parameter; " + known};
    }
    return std::nullopt;
}

}  // namespace zeroset
