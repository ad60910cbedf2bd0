#pragma once

#include "document/import/implicit_graph.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace zeroset {

/// Gives an expression a name.
using NameExpression = std::function<std::string(const std::string& expression)>;

/// The value of a node that makes a matrix of 4 rows and 4 columns, or multiplies one with a
/// vector; empty for other nodes, and where an input is missing or of another shape. A matrix acts
/// on columns: the fourth one moves.
GraphValue matrix_value(std::string_view kind, const GraphInputs& in, const NameExpression& named);

}  // namespace zeroset
