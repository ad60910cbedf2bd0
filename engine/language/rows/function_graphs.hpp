#pragma once

#include "engine/language/rows/row_maker.hpp"

#include <cstddef>
#include <expected>
#include <optional>
#include <string_view>

namespace zeroset {

/// In a text of definitions only, functions that no other one calls are surfaces: those of two of
/// x, y and z their graphs, those of all three or of a vector where they are 0.
class FunctionGraphs {
public:
    using Result = std::expected<std::optional<RowSurface>, ParseError>;

    FunctionGraphs(ExpressionReader& reader, RowMaker& maker) : reader_(reader), maker_(maker) {}

    /// Whether a definition is such a function. All definitions have been read.
    [[nodiscard]] bool may_read(const Definition& definition) const;
    /// The graph over the plane of the two, or the zeros; nothing of a function of others.
    Result read(Definition& definition);

private:
    Result read_of_point(Definition& definition);
    Result surface(Definition& definition, const BuiltValues& arguments, std::string_view up);
    [[nodiscard]] std::size_t offset_of(const Definition& definition) const {
        return reader_.tree().statements[definition.statement].offset;
    }

    ExpressionReader& reader_;
    RowMaker& maker_;
};

}  // namespace zeroset
