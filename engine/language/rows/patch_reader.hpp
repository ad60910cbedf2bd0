#pragma once

#include "engine/language/rows/reading_text.hpp"
#include "engine/language/rows/row_maker.hpp"
#include "engine/language/rows/row_variables.hpp"

#include <string>
#include <vector>

namespace zeroset {

/// Reads rows that are given by a point: parametric surfaces, curves and points.
class PatchReader {
public:
    /// All of these outlive this object.
    PatchReader(ExpressionReader& reader, RowMaker& maker, RowVariables& variables,
                const ReadingText& text)
        : reader_(reader), maker_(maker), variables_(variables), text_(text) {}

    /// Whether a row is to be read so: what it relates is no condition, and it is a vector that is
    /// written out, or is restricted by ranges of its variables alone.
    [[nodiscard]] bool may_read(std::size_t statement) const;
    RowResult read(std::size_t statement);

private:
    /// A variable and the range that a row gives it.
    struct Ranged {
        std::string name;
        SyntaxId lo, hi;
        std::size_t offset;
    };
    using Ranges = std::vector<Ranged>;
    class OneRow;

    [[nodiscard]] SyntaxId point_in(const StatementSyntax& statement) const;
    bool add_ranges(SyntaxId id, Ranges& ranges) const;
    [[nodiscard]] std::expected<Ranges, ParseError> ranges_of(
        const StatementSyntax& statement) const;

    ExpressionReader& reader_;
    RowMaker& maker_;
    RowVariables& variables_;
    const ReadingText& text_;
};

}  // namespace zeroset
