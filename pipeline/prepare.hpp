#pragma once

#include "document/document.hpp"
#include "document/row_program.hpp"
#include "pipeline/color_formulas.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/input_error.hpp"

#include <expected>
#include <memory>
#include <string_view>

namespace zeroset {

/// A document with its rows as they were read, or the error in them.
struct ReadDocument {
    Document document;
    std::expected<RowProgram, InputError> rows;
};
ReadDocument read_document(Document document);
/// Makes a document of a text, one row for each statement. `files`: the document's.
ReadDocument read_document_text(std::string_view text,
                                std::shared_ptr<const FieldSource> files = nullptr);

/// The code that draws a document.
struct PreparedDocument {
    std::shared_ptr<const Formula> formula;
    std::shared_ptr<const ColorFormulas> colors;
};

/// Makes what pictures of a document need: the code of its rows, tightest in its clip box, and the
/// code of its colours. `rows`: the document's rows as they were read. Thread-safe.
std::expected<PreparedDocument, InputError> prepare(const Document& document, RowProgram rows,
                                                    Preparation how);

}  // namespace zeroset
