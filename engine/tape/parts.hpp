#pragma once

#include "engine/algebra/facts.hpp"
#include "engine/expr/expr.hpp"
#include "engine/kernel/kernel.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace zeroset {

// Parts of a formula: the largest subgraphs without choices (min, max, if, where) and switches
// (engine/algebra/switches.hpp) below its choices, as the spheres of a union. Parts that differ
// only in their constants have one shape, whose code takes these constants as uniforms: a thousand
// spheres need one piece of machine code.

/// A function that parts have in common.
struct PartShape {
    Expr expr;
    Facts facts;  ///< of its root
    /// The formula's uniforms that come before the constants of a part.
    std::vector<std::size_t> shared;
    Kernel kernel;  ///< of `expr`
};

struct Part {
    NodeId root = 0;        ///< in the formula
    std::size_t shape = 0;  ///< its place among the shapes
    Uniforms uniforms;      ///< of the shape's code: places for the shared ones, then constants
};

/// Code of a shape; nothing where it cannot be made.
using MakeCode = std::function<std::optional<Kernel>(const Expr& shape)>;

struct Parts {
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::vector<PartShape> shapes;  ///< without code until `make_code`
    std::vector<Part> parts;
    std::vector<std::uint32_t> of_node;  ///< the part that begins at a node of the formula, or none

    /// Nodes of all shapes together.
    [[nodiscard]] std::size_t nodes() const;
    /// Parts whose shapes get no code are dropped.
    void make_code(const MakeCode& make);
};

/// The parts of a formula, with no more nodes in all shapes than `most_nodes`: those that stand for
/// most of the formula first. `facts` are the formula's. A formula without choices has none.
Parts parts_of(const Expr& expr, std::span<const Facts> facts, std::size_t most_nodes);

/// Uniforms for a part's code where the formula's are `of_formula`; valid until this thread's next
/// call.
template <class Real>
const Real* box_uniforms(const PartShape& shape, const Part& part, const Real* of_formula);
template <class Real>
const Real* point_uniforms(const PartShape& shape, const Part& part, const Real* of_formula);

/// A graph as what its shape's code makes of its constants.
struct ShapedGraph {
    PartShape shape;
    Part part;
};

/// `interpreted`, the kernel of a graph, with the code of the graph's shape and the graph's
/// constants in place of the interpreter's.
Kernel kernel_of_shape(Kernel interpreted, ShapedGraph graph);

/// The code of a part's shape with the part's constants. Neither it nor a copy outlives `parts`.
Kernel kernel_of_part(const Parts& parts, std::uint32_t part);

}  // namespace zeroset
