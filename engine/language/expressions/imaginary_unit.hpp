#pragma once

#include "engine/language/expressions/definition_table.hpp"

namespace zeroset {

/// Whether a name that a text does not define is the imaginary unit where complex numbers are read:
/// i, or Mathematica's I.
bool may_be_imaginary_unit(std::string_view name);

/// Whether a text is about complex numbers: it asks for Re, Im, arg or conj, or for the absolute
/// value of a sum such as x + i y or of a power such as e^(i x), there or in what it names.
/// Elsewhere i is a letter as any other.
bool has_complex_numbers(const SyntaxTree& tree, DefinitionTable& table);

}  // namespace zeroset
