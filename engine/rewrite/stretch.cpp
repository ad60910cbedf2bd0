#include "engine/rewrite/stretch.hpp"

#include "engine/expr/copy.hpp"
#include "engine/expr/patch_graph.hpp"
#include "engine/expr/simplify.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace zeroset {
namespace {

/// The function with x, y and z divided by their stretch.
Expr at_unstretched(const Expr& f, const glm::dvec3& stretch) {
    ExprBuilder builder;
    std::vector<NodeId> copies;
    copies.reserve(f.nodes().size());
    for (const Node& node : f.nodes()) {
        NodeId copy = copy_node(builder, node, copies);
        const bool is_place = node.op == Op::Variable && node.number < variable_w;
        const double factor = is_place ? stretch[node.number] : 1.0;
        if (factor != 1.0) copy = make_divide(builder, copy, builder.constant(factor));
        copies.push_back(copy);
    }
    const auto names = f.parameters();
    return builder.finish(copies.back(), {names.begin(), names.end()});
}

/// A point's coordinates times the stretch.
Expr patch_stretched(const PatchGraphs& patch, const glm::dvec3& stretch) {
    ExprBuilder builder;
    std::array<NodeId, 3> point{};
    std::optional<RowBox> box = patch.box;
    for (std::size_t i = 0; i < 3; ++i) {
        const double factor = stretch[static_cast<int>(i)];
        point.at(i) = make_multiply(builder, builder.constant(factor),
                                    copy_nodes(builder, patch.point.at(i)).back());
        if (!box) continue;
        box->at(2 * i) *= factor;
        box->at(2 * i + 1) *= factor;
    }
    const auto names = patch.point[0].parameters();
    return builder.finish(make_patch(builder, patch.kind, point, box),
                          {names.begin(), names.end()});
}

}  // namespace

Expr stretched(const Expr& f, const glm::dvec3& stretch) {
    if (stretch == glm::dvec3(1.0)) return f;
    const auto patch = patch_of(f);
    if (!patch || patch->kind == PatchKind::Meeting) return at_unstretched(f, stretch);
    return patch_stretched(*patch, stretch);
}

}  // namespace zeroset
