#pragma once

#include "engine/language/expressions/definition_table.hpp"

namespace zeroset {

/// Notes what r and rho are in a row that seems to go by the other of the two distances: z = r^2,
/// rho = 2 cos phi; and what theta and phi are, which others exchange.
void note_distance(const SyntaxTree& tree, DefinitionTable& table, std::size_t statement,
                   Notes& notes);

}  // namespace zeroset
