#include "pipeline/mesh_solid.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/choice_tree.hpp"
#include "engine/rewrite/differences/derivatives.hpp"
#include "engine/rewrite/polynomial/tighten.hpp"
#include "engine/rewrite/surface_functions.hpp"
#include "engine/trace/caps.hpp"
#include "jit/compile.hpp"
#include "pipeline/sample_region.hpp"

#include <utility>

namespace zeroset {
namespace {

// LLVM takes about 1 ms for a node; larger graphs are interpreted.
constexpr std::size_t most_nodes_of_mesh_code = 3'000;
// LLVM takes some 25 ms to be loaded and 10 for a function; so many nodes of boxes and points take
// the interpreter about as long.
constexpr std::size_t patient_nodes = 4'000'000;

/// Functions in double, machine code from when it pays.
Kernel quick_kernel(const Expr& expr) {
    const bool small = expr.nodes().size() <= most_nodes_of_mesh_code;
    return small ? jit::compile_when_called(expr, {.patient_nodes = patient_nodes})
                 : interpret(expr);
}

SolidNode::Kind kind_of(ChoiceTree::Kind kind, double sign) {
    switch (kind) {
        case ChoiceTree::Kind::Leaf: return SolidNode::Kind::Leaf;
        case ChoiceTree::Kind::Max: return sign > 0 ? SolidNode::Kind::Max : SolidNode::Kind::Min;
        case ChoiceTree::Kind::Min: return sign > 0 ? SolidNode::Kind::Min : SolidNode::Kind::Max;
    }
    return SolidNode::Kind::Leaf;
}

/// The function's pieces: one where it is not defined everywhere, as then a piece alone is not.
ChoiceTree pieces_of(const Expr& f) {
    constexpr std::size_t most_pieces = 40;
    return choice_tree(f, is_defined_everywhere(f) ? most_pieces : 0);
}

/// Adds sign * f, in pieces without kinks where it has few; returns its node.
std::uint32_t add_function(const Expr& f, double sign, MeshSolid& solid) {
    const ChoiceTree tree = pieces_of(f);
    const auto first_part = static_cast<std::uint32_t>(solid.parts.size());
    const auto first_node = static_cast<std::uint32_t>(solid.nodes.size());
    for (const Expr& function : tree.functions)
        solid.parts.push_back(solid_part(function, solid.box));
    for (const ChoiceTree::Node& node : tree.nodes) {
        const bool leaf = node.kind == ChoiceTree::Kind::Leaf;
        solid.add({.kind = kind_of(node.kind, sign),
                   .a = node.a + (leaf ? first_part : first_node),
                   .b = node.b + first_node,
                   .sign = sign});
    }
    return static_cast<std::uint32_t>(solid.nodes.size() - 1);
}

}  // namespace

SolidPart solid_part(const Expr& f, const Box& clip) {
    SolidPart part;
    const Kernel kernel = quick_kernel(f);
    part.range = kernel.in_double.range;
    part.value = kernel.in_double.value;
    part.branches = kernel.branches;
    const std::array<Expr, 3> slopes = gradient_of(f);
    for (std::size_t axis = 0; axis < 3; ++axis)
        part.gradient[axis] =
            quick_kernel(tightened(slopes[axis], sample_region(clip))).in_double.range;
    part.defined_everywhere = is_defined_everywhere(f);
    return part;
}

std::expected<std::vector<SurfaceSolid>, InputError> surface_solids(const PictureRequest& request) {
    const Scene scene = scene_of(request);
    const std::vector<std::string> texts = request.formula->surface_texts;
    std::vector<SurfaceSolid> solids;
    for (std::size_t i = 0; i < request.surfaces.size(); ++i) {
        const std::size_t index = request.surfaces[i].index;
        const RestrictedExpr restricted = without_restriction(request.formula->drawn[index]);
        SurfaceSolid surface{.number = index + 1, .text = texts[index], .solid = {}};
        MeshSolid& solid = surface.solid;
        solid.uniforms = scene.uniforms;
        solid.box = scene.clip;
        solid.cuts = cuts_of(scene.clip, scene.region);
        add_function(restricted.function, solid_sign(scene, i) < 0 ? 1.0 : -1.0, solid);
        solid.surface_parts = solid.parts.size();
        for (const Expr& bound : restricted.bounds) {
            const auto root = static_cast<std::uint32_t>(solid.nodes.size() - 1);
            const std::uint32_t own = add_function(bound, 1.0, solid);
            solid.add({.kind = SolidNode::Kind::Max, .a = root, .b = own});
        }
        solids.push_back(std::move(surface));
    }
    return solids;
}

}  // namespace zeroset
