#include "pipeline/surface_code.hpp"

#include "engine/algebra/graph_facts.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/passes.hpp"
#include "engine/rewrite/sample/form_sample.hpp"
#include "engine/tape/shape_memory.hpp"
#include "pipeline/sample_region.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>

namespace zeroset {
namespace {

using Kernels = std::vector<Kernel>;

// With at least so many choices, most of a surface may be left out in a small cell, so that
// interpreting the rest may be quicker than machine code of the whole.
constexpr std::size_t many_choices = 24;
// Number of nodes that machine code evaluates in the time of one interpreter step.
constexpr double nodes_a_step = 16;
// Largest number of nodes compiled as a whole. LLVM takes 1 ms for a node, 3 ms at its most
// thorough.
constexpr std::size_t most_whole_nodes = 2'000;
// Largest number of nodes of parts that are compiled; the rest is interpreted.
constexpr std::size_t most_part_nodes = 1'000;
// Largest cost of the parts' code, in nodes, that pays for a single picture: 89 shapes of 971 nodes
// took 2 s to compile for a frame of 0.2 s.
constexpr std::size_t most_part_cost = 1'000;
constexpr std::size_t cost_of_shape = 8;
// Above this number of nodes LLVM's thorough compilation takes seconds: for 2000 terms 23 s, the
// hasty one 0.7 s.
constexpr std::size_t most_thorough_nodes = 200;
// Number of nodes that the interpreter evaluates in the time that LLVM takes for a function.
constexpr std::size_t patient_nodes = 30'000'000;

bool is_one(CodeUse use) { return use == CodeUse::OnePicture || use == CodeUse::LongPicture; }

std::size_t choices_in(const Expr& expr) {
    // Where does not count: a restriction has no alternative to evaluate in its place.
    const auto chooses = [](const Node& node) {
        return may_be_operand(node.op) && node.op != Op::Where;
    };
    return static_cast<std::size_t>(std::ranges::count_if(expr.nodes(), chooses));
}

jit::CompileOptions options_for(CodeUse use, Precision precision, const Expr& surface) {
    const bool large = surface.nodes().size() > most_thorough_nodes;
    return {.with_double = precision == Precision::Double,
            .quick = use == CodeUse::FirstPicture,
            .hasty = is_one(use) || (use == CodeUse::FirstPicture && large),
            .patient_nodes = is_one(use) ? patient_nodes : 0};
}

/// Makes a kernel that interprets the choices and runs machine code of the parts between them.
Kernel by_parts(const Expr& drawn, CodeUse use, Precision precision) {
    const Expr surface = with_outer_choices(drawn);
    std::vector<Facts> facts = facts_of(surface);
    Parts parts = parts_of(surface, facts, most_part_nodes);
    const std::size_t cost = parts.nodes() + cost_of_shape * parts.shapes.size();
    if (is_one(use) && cost > most_part_cost) parts = {};
    parts.make_code([&](const Expr& shape) -> std::optional<Kernel> {
        auto kernel = jit::compile(shape, options_for(use, precision, shape));
        if (!kernel) return std::nullopt;
        return std::move(*kernel);
    });
    Kernel kernel = interpret(surface, std::move(facts), std::move(parts));
    kernel.has_double = precision == Precision::Double;
    return kernel;
}

/// The surfaces that code was made for, if it was for one picture or a first one.
ShapeMemory& shapes_seen() {
    static ShapeMemory instance;
    return instance;
}

/// Compiles one surface as a whole, or its shape.
std::expected<Kernel, jit::CompileError> whole_code(const Expr& surface,
                                                    std::optional<ShapedGraph> shaped, CodeUse use,
                                                    Precision precision) {
    const jit::CompileOptions options = options_for(use, precision, surface);
    if (!shaped || jit::is_compiled(surface, options)) return jit::compile(surface, options);
    auto code = jit::compile(shaped->shape.expr, options);
    if (!code) return code;
    shaped->shape.kernel = std::move(*code);
    return kernel_of_shape(interpret(surface), std::move(*shaped));
}

/// Tells of each surface whether its code is made of its parts.
std::vector<bool> made_of_parts(std::span<const Expr> surfaces, const Box& region, CodeUse use) {
    std::vector<bool> result;
    for (const Expr& surface : surfaces) {
        // For a single picture the decision has been made already and is part of `use`.
        result.push_back(is_one(use) ? use == CodeUse::OnePicture && has_many_choices(surface)
                                     : is_made_of_parts(surface, region));
    }
    return result;
}

}  // namespace

bool has_many_choices(const Expr& surface) { return choices_in(surface) >= many_choices; }

double steps_left(const Expr& surface, const Kernel& interpreted, const Box& region) {
    if (interpreted.specializer == nullptr) return static_cast<double>(interpreted.steps);
    return FormSample(surface, sample_region(region)).steps_left(interpreted);
}

bool is_made_of_parts(const Expr& surface, const Box& region) {
    if (!has_many_choices(surface)) return false;
    const std::size_t nodes = surface.nodes().size();
    if (nodes > most_whole_nodes) return true;
    const double steps = steps_left(surface, interpret(surface), region);
    return static_cast<double>(nodes) > nodes_a_step * steps;
}

std::expected<Kernels, jit::CompileError> machine_code(std::span<const Expr> surfaces,
                                                       const Box& region, CodeUse use,
                                                       Precision precision) {
    const std::vector<bool> by_their_parts = made_of_parts(surfaces, region, use);
    std::vector<Expr> wholes;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (!by_their_parts[i]) wholes.push_back(surfaces[i]);
    }
    // Constants that stand in the code make it quicker, so code for many pictures shares shapes
    // only among these surfaces.
    ShapeMemory only_these;
    ShapeMemory& memory = use == CodeUse::Pictures ? only_these : shapes_seen();
    auto shapes = memory.shape(wholes);
    auto shape = shapes.begin();
    Kernels kernels;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (by_their_parts[i]) {
            kernels.push_back(by_parts(surfaces[i], use, precision));
            continue;
        }
        auto kernel = whole_code(surfaces[i], std::move(*shape++), use, precision);
        if (!kernel) return std::unexpected(kernel.error());
        kernels.push_back(std::move(*kernel));
    }
    return kernels;
}

std::size_t nodes_of_shapes(std::span<const Expr> surfaces) {
    std::unordered_set<std::string> seen;
    std::size_t nodes = 0;
    for (const Expr& surface : surfaces) {
        if (seen.insert(skeleton_of(surface).key()).second) nodes += surface.nodes().size();
    }
    return nodes;
}

bool is_compiled(std::span<const Expr> surfaces, CodeUse use) {
    if (std::ranges::any_of(surfaces, [](const Expr& s) { return has_many_choices(s); }))
        return false;
    const auto shapes = shapes_seen().shape(surfaces);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const jit::CompileOptions options = options_for(use, Precision::Float, surfaces[i]);
        if (jit::is_compiled(surfaces[i], options)) continue;
        if (!shapes[i] || !jit::is_compiled(shapes[i]->shape.expr, options)) return false;
    }
    return true;
}

}  // namespace zeroset
