#include "pipeline/prepare.hpp"

#include "document/document.hpp"

#include <utility>

namespace zeroset {

ReadDocument read_document(Document document) {
    auto rows = read_rows(document);
    if (rows) return {.document = std::move(document), .rows = std::move(*rows)};
    InputError error = input_error(rows.error(), joined_rows(document).text);
    return {.document = std::move(document), .rows = std::unexpected(std::move(error))};
}

ReadDocument read_document_text(std::string_view text, std::shared_ptr<const FieldSource> files) {
    TextDocument read = read_text(text, std::move(files));
    if (read.rows) return {.document = std::move(read.document), .rows = std::move(*read.rows)};
    return {.document = std::move(read.document),
            .rows = std::unexpected(input_error(read.rows.error(), text))};
}

std::expected<PreparedDocument, InputError> prepare(const Document& document, RowProgram rows,
                                                    Preparation how) {
    auto formula = prepare_formula(std::move(rows), {document.clip, stretch_of(document)}, how);
    if (!formula) return std::unexpected(formula.error());
    auto colors = color_formulas(*formula, document.coloring, formula->stretch);
    if (!colors) return std::unexpected(colors.error());
    return PreparedDocument{.formula = std::make_shared<const Formula>(std::move(*formula)),
                            .colors = std::make_shared<const ColorFormulas>(std::move(*colors))};
}

}  // namespace zeroset
