#pragma once

#include "engine/language/expressions/expression_reader.hpp"
#include "engine/language/rows/solid_boundaries.hpp"

#include <expected>
#include <optional>

namespace zeroset {

/// Reads rows that are equations, expressions or conditions.
class EquationReader {
public:
    struct Equation {
        NodeId root;  ///< 0 on the surface; where the restrictions do not hold it has no value
        bool solid;   ///< the row is a condition, which holds where the root is below 0
    };

    explicit EquationReader(ExpressionReader& reader)
        : reader_(reader), boundaries_(reader.values()) {}

    /// The row as it is typed: it may depend on no point.
    std::expected<Equation, ParseError> read(std::size_t statement);
    /// All restrictions of a row as one condition; nothing where it has none.
    std::expected<std::optional<NodeId>, ParseError> restriction(std::size_t statement);

private:
    std::expected<Equation, ParseError> solid(NodeId condition, std::size_t statement);

    ExpressionReader& reader_;
    SolidBoundaries boundaries_;
};

}  // namespace zeroset
