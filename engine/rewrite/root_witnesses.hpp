#pragma once

#include "engine/expr/expr.hpp"

#include <optional>
#include <vector>

// f^2, -f max(f, g) and if(u < v, g, u - v) touch 0 or jump to it where one of their parts crosses
// it: a proved root of that part is one of the whole. Remainders jump to 0 where the one that is
// nearest to 0 crosses it.

namespace zeroset {

/// Functions each of whose zeros is one of f where f is defined; at most a few, none where f is its
/// only one.
std::vector<Expr> root_witnesses(const Expr& f);

/// Whether it is defined for all values of the variables; not seen for all that are.
bool is_defined_everywhere(const Expr& f);

/// A function such that f is defined wherever it is continuous: a sum of the operators of f that
/// lack values, and of 1/(x^2 + y^2) for angles. Nothing where that cannot be told.
std::optional<Expr> domain_witness(const Expr& f);

}  // namespace zeroset
