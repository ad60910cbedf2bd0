#pragma once

#include "engine/expr/patch_graph.hpp"

#include <cstddef>

namespace zeroset {

/// A box that cuts what is drawn of the statements that begin at bytes `begin` to `end` of a text.
struct CutText {
    std::size_t begin, end;
    RowBox box;
};

}  // namespace zeroset
