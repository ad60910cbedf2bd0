#pragma once

#include "engine/interpret/parts.hpp"

#include <cstdint>

namespace zeroset {

/// A graph as what its shape's code makes of its constants.
struct ShapedGraph {
    PartShape shape;
    Part part;
};

/// The code of the graph's shape with the graph's constants; `expr` is the graph.
Kernel kernel_of_shape(const Expr& expr, ShapedGraph graph);

/// The code of a part's shape with the part's constants. Neither it nor a copy outlives `parts`.
Kernel kernel_of_part(const Parts& parts, std::uint32_t part);

}  // namespace zeroset
