#include "app/formula.hpp"

#include "app/text.hpp"
#include "app/timing.hpp"
#include "engine/expr/drawn_form.hpp"
#include "engine/expr/interpret.hpp"
#include "engine/expr/outer_choices.hpp"
#include "engine/expr/root_witnesses.hpp"
#include "engine/expr/unrestricted.hpp"
#include "jit/compile.hpp"

#include <algorithm>
#include <chrono>

namespace zeroset {
namespace {

using Clock = std::chrono::steady_clock;

// LLVM takes 0.4 to 1 ms and 25 kB for a node.
constexpr std::size_t most_nodes = 8'000;

// Of so many, machine code of the parts is quicker than that of all, and made sooner.
constexpr std::size_t many_choices = 24;
// Of the shapes of such parts; the rest is interpreted.
constexpr std::size_t most_part_nodes = 1'000;
// Where code for the parts takes longer than this, in nodes, one picture is drawn sooner without:
// 89 shapes of 971 nodes took 2 s for a frame of 0.2.
constexpr std::size_t most_part_cost = 1'000;
constexpr std::size_t cost_of_shape = 8;
// LLVM's quicker code of more takes it seconds; of 2000 terms 23 s, where hasty code takes 0.7.
constexpr std::size_t most_thorough_nodes = 200;
// The interpreter evaluates so many in the time that LLVM takes for a function.
constexpr std::size_t patient_nodes = 30'000'000;

SampleRegion sample_region(const Box& box) {
    SampleRegion region;
    for (int i = 0; i < 3; ++i) {
        region.lo[static_cast<std::size_t>(i)] = box.lo[i];
        region.hi[static_cast<std::size_t>(i)] = box.hi[i];
    }
    return region;
}

std::size_t choices_in(const Expr& expr) {
    const auto is_choice = [](const Node& node) {
        return node.op == Op::Min || node.op == Op::Max || node.op == Op::If ||
               node.op == Op::And || node.op == Op::Or;
    };
    return static_cast<std::size_t>(std::ranges::count_if(expr.nodes(), is_choice));
}

bool is_made_of_parts(const Expr& surface) { return choices_in(surface) >= many_choices; }

jit::CompileOptions options_for(CodeUse use, Precision precision, const Expr& surface) {
    const bool large = surface.nodes().size() > most_thorough_nodes;
    return {.with_double = precision == Precision::Double,
            .quick = use == CodeUse::FirstPicture,
            .hasty = use == CodeUse::OnePicture || (use == CodeUse::FirstPicture && large),
            .patient_nodes = use == CodeUse::OnePicture ? patient_nodes : 0};
}

/// When a formula is interpreted at first.
enum class Interpreted : std::uint8_t { Never, UnlessCompiled, Always };

CodeState code_for(const std::vector<Expr>& surfaces, CodeUse use, Interpreted first) {
    std::size_t nodes = 0;
    for (const Expr& surface : surfaces) {
        if (!is_made_of_parts(surface)) nodes += surface.nodes().size();
    }
    if (nodes > most_nodes) return CodeState::Interpreted;
    if (first == Interpreted::Never) return CodeState::Machine;
    if (first == Interpreted::Always) return CodeState::InterpretedFirst;
    const auto is_compiled = [&](const Expr& surface) {
        return !is_made_of_parts(surface) &&
               jit::is_compiled(surface, options_for(use, Precision::Float, surface));
    };
    return std::ranges::all_of(surfaces, is_compiled) ? CodeState::Machine
                                                      : CodeState::InterpretedFirst;
}

/// Machine code of parts, and an interpreter of the choices between them.
Kernel by_parts(const Expr& drawn, CodeUse use, Precision precision) {
    const Expr surface = with_outer_choices(drawn);
    std::vector<Facts> facts = facts_of(surface);
    Parts parts = parts_of(surface, facts, most_part_nodes);
    const std::size_t cost = parts.nodes() + cost_of_shape * parts.shapes.size();
    if (use == CodeUse::OnePicture && cost > most_part_cost) parts = {};
    parts.make_code([&](const Expr& shape) -> std::optional<Kernel> {
        auto kernel = jit::compile(shape, options_for(use, precision, shape));
        if (!kernel) return std::nullopt;
        return std::move(*kernel);
    });
    Kernel kernel = interpret(surface, std::move(facts), std::move(parts));
    kernel.has_double = precision == Precision::Double;
    return kernel;
}

std::expected<Kernel, InputError> machine_code(const Expr& surface, CodeUse use,
                                               Precision precision) {
    if (is_made_of_parts(surface)) return by_parts(surface, use, precision);
    auto kernel = jit::compile(surface, options_for(use, precision, surface));
    if (!kernel) return wrong_input("the formula cannot be compiled: " + kernel.error().message);
    return std::move(*kernel);
}

/// Of all surfaces, or of their parts.
std::expected<std::vector<Kernel>, InputError> machine_code(const std::vector<Expr>& surfaces,
                                                            CodeUse use, Precision precision) {
    std::vector<Kernel> kernels;
    for (const Expr& surface : surfaces) {
        auto kernel = machine_code(surface, use, precision);
        if (!kernel) return std::unexpected(kernel.error());
        kernels.push_back(std::move(*kernel));
    }
    return kernels;
}

/// Adds what the kernels of the drawn surfaces know of their functions' zeros.
void add_witnesses(Formula& formula) {
    for (std::size_t i = 0; i < formula.drawn.size(); ++i) {
        Kernel& kernel = formula.kernels[i];
        for (const Expr& witness : root_witnesses(formula.drawn[i]))
            kernel.witnesses.push_back(interpret(witness).range_double);
        kernel.defined_everywhere = is_defined_everywhere(formula.drawn[i]);
    }
}

/// The formula with the interpreter's code, which is always in both types.
Formula interpreted(Formula formula) {
    formula.kernels.clear();
    for (const Expr& surface : formula.drawn) {
        Kernel& kernel = formula.kernels.emplace_back(interpret(surface));
        // To find what can be left out of few choices takes longer than they do.
        if (!is_made_of_parts(surface)) kernel.shortener = nullptr;
    }
    add_witnesses(formula);
    return formula;
}

std::expected<Formula, InputError> prepared(std::string_view text, const Box& region, CodeUse use,
                                            Interpreted first) {
    const auto start = Clock::now();
    auto program = read_formula(text);
    if (!program) return std::unexpected(program.error());
    Formula formula{std::string(text), std::move(*program), {}, {}, {}, CodeState::Machine, 0.0};
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
        auto kernels = machine_code(formula.drawn, use, Precision::Float);
        if (!kernels) return std::unexpected(kernels.error());
        formula.kernels = std::move(*kernels);
        add_witnesses(formula);
    }
    formula.compile_ms = ms_since(start);
    return formula;
}

}  // namespace

InputError input_error(const ParseError& error, std::string_view text) {
    const std::string hint = error.hint.empty() ? "" : "; " + error.hint;
    return {error.reason + hint, column_of(text, error.offset),
            std::string(line_at(text, error.offset)), error.offset, error.unfinished};
}

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

std::expected<Formula, InputError> interpreted_formula(std::string_view text, const Box& region) {
    return prepared(text, region, CodeUse::FirstPicture, Interpreted::Always);
}

std::expected<Formula, InputError> with_machine_code(const Formula& formula, CodeUse use,
                                                     Precision precision) {
    const auto start = Clock::now();
    auto kernels = machine_code(formula.drawn, use, precision);
    if (!kernels) return std::unexpected(kernels.error());
    Formula result = formula;
    for (std::size_t i = 0; i < kernels->size(); ++i) {
        (*kernels)[i].witnesses = formula.kernels[i].witnesses;
        (*kernels)[i].defined_everywhere = formula.kernels[i].defined_everywhere;
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

bool has_parts(const Formula& formula) {
    return std::ranges::any_of(formula.drawn, is_made_of_parts);
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

std::string describe(const InputError& error) {
    std::string text = "error: " + error.reason + "\n";
    if (!error.column || error.line.empty()) return text;
    const auto [line, caret] = excerpt(error.line, *error.column - 1);
    return text + "  " + line + "\n  " + std::string(caret, ' ') + "^\n";
}

}  // namespace zeroset
