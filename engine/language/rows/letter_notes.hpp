#pragma once

#include "engine/language/expressions/expression_reader.hpp"

namespace zeroset {

/// Notes on T = x^2 - y^2 that its surface is a level set of a slider T, and no graph.
void note_level(ExpressionReader& reader, std::size_t statement, NodeId root);

/// Notes that e is no parameter in a text with the parameters a, b, c, d and f.
void note_euler(ExpressionReader& reader);

}  // namespace zeroset
