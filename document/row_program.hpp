#pragma once

#include "document/document.hpp"
#include "engine/language/parse.hpp"

#include <expected>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// The program that the rows of a document make together. It is read once and travels with all that
/// is made of it.
struct RowProgram {
    std::string text;  ///< what was read
    std::shared_ptr<const Program> program =
        nullptr;                         ///< of `text`; offsets of its readings are in it
    std::vector<int> surface_rows = {};  ///< id of the row of each of the program's surfaces; 0: a
                                         ///< surface that is no row's and is not to be drawn
    std::vector<std::string> surface_texts = {};         ///< how each of these surfaces was read
    std::shared_ptr<const FieldSource> files = nullptr;  ///< of the document
};

/// Whether both are the same text, read of the same files as these were: its functions are the
/// same.
bool same_functions(const RowProgram& a, const RowProgram& b);

/// Reads the rows of a document as one text. Offsets of an error are in joined_rows(document).
std::expected<RowProgram, ParseError> read_rows(const Document& document);

/// A text as a document with a row for each statement, and what it says. `files`: the document's.
struct TextDocument {
    Document document;  ///< ids from 1 on; a row for each line where the text cannot be read
    std::expected<RowProgram, ParseError> rows;  ///< offsets are in the text as it was given
};
TextDocument read_text(std::string_view text, std::shared_ptr<const FieldSource> files);

/// Rows for a text of one or more statements: one for each. A text that cannot be read becomes a
/// row for each line.
std::vector<std::string> rows_of(std::string_view text, const FieldSource* files);

}  // namespace zeroset
