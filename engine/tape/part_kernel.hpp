#pragma once

#include "engine/tape/parts.hpp"

#include <cstdint>

namespace zeroset {

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
