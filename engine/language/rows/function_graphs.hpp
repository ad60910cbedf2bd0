#pragma once

#include "engine/language/rows/row_maker.hpp"

namespace zeroset {

/// In a text of definitions only, functions of two of x, y and z that no other one calls are
/// surfaces: their graphs.
class FunctionGraphs {
public:
    FunctionGraphs(ExpressionReader& reader, RowMaker& maker) : reader_(reader), maker_(maker) {}

    /// Whether a definition is such a function. All definitions have been read.
    [[nodiscard]] bool may_read(const Definition& definition) const;
    /// The graph over the plane of the two; nothing of a function of others.
    std::expected<std::optional<RowSurface>, ParseError> read(Definition& definition);

private:
    ExpressionReader& reader_;
    RowMaker& maker_;
};

}  // namespace zeroset
