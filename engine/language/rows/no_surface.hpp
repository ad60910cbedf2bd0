#pragma once

#include "engine/language/expressions/definition_table.hpp"

#include <optional>

namespace zeroset {

/// The error for a text of definitions only.
ParseError error_without_surface(const SyntaxTree& tree, DefinitionTable& table);

/// The error for x = ..., y = ... and z = ... of u and v in rows of their own, a parametric
/// surface; nothing for other texts.
std::optional<ParseError> error_for_parametric(const SyntaxTree& tree, DefinitionTable& table);

}  // namespace zeroset
