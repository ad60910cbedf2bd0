#pragma once

#include "engine/language/syntax/syntax.hpp"

// Private to the syntax room.

namespace zeroset {

/// Makes one row of x = ..., y = ... and z = ..., in rows of their own or behind commas, where none
/// of the three goes by coordinates, and ranges of one or two variables stand beside them if there
/// are several rows:
/// x = u; y = v; z = u v; 0 < u < 1; 0 < v < 1 becomes (u, v, u v), 0 < u < 1, 0 < v < 1.
void join_coordinates(SyntaxTree& tree);

}  // namespace zeroset
