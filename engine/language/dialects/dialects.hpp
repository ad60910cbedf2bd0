#pragma once

#include "engine/language/dialects/expressions.hpp"
#include "engine/language/dialects/source_text.hpp"
#include "engine/language/vocabulary/parse_notes.hpp"
#include "engine/language/vocabulary/reading.hpp"

#include <expected>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace zeroset {

/// A text of another program in the words of the language.
struct DialectText {
    SourceText text;
    AskedBox box;                ///< ranges of x, y and z that plotting commands give
    std::size_t box_offset = 0;  ///< of the last command that gives one
    Notes notes;                 ///< what was read so, by offsets of the typed text
    /// From where to where in the typed text stands what may be several statements of the words.
    std::vector<std::pair<std::size_t, std::size_t>> wholes;

    /// Where the statement at `place` of the words begins in the typed text.
    [[nodiscard]] std::size_t statement_offset(std::size_t place) const;
};

/// Reads what the language itself does not: plotting commands of Mathematica, Maple, MATLAB, Sage,
/// SymPy, Maxima, gnuplot and GeoGebra, the lines around them that draw nothing, functions with
/// steps, sums and cases as these write them. The rest is kept as typed. Nothing where the text has
/// none of it; an error names a command that is not understood. `typed` must outlive the result.
std::expected<std::optional<DialectText>, ParseError> read_dialects(std::string_view typed);

}  // namespace zeroset
