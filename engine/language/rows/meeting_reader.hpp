#pragma once

#include "engine/language/rows/equation_reader.hpp"
#include "engine/language/rows/reading_text.hpp"
#include "engine/language/rows/row_maker.hpp"

namespace zeroset {

/// Reads rows of two equations joined by `and`: the curves where their surfaces meet.
class MeetingReader {
public:
    /// All of these outlive this object.
    MeetingReader(ExpressionReader& reader, RowMaker& maker, EquationReader& equations,
                  const ReadingText& text)
        : reader_(reader), maker_(maker), equations_(equations), text_(text) {}

    [[nodiscard]] bool may_read(std::size_t statement) const;
    RowResult read(std::size_t statement);

private:
    ExpressionReader& reader_;
    RowMaker& maker_;
    EquationReader& equations_;
    const ReadingText& text_;
};

}  // namespace zeroset
