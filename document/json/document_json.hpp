#pragma once

#include "document/document.hpp"

#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// A document as text: JSON with a "zeroset" format version, see resources/docs/documents.md.

namespace zeroset {

inline constexpr int document_format = 1;

/// `shown_on`: the background that the document was seen on, where it has none of its own.
std::string text_of(const Document& document,
                    const std::optional<Background>& shown_on = std::nullopt);

/// A document read from text; its rows have the ids 1, 2, ...
struct ParsedDocument {
    Document document;
    std::optional<Background> shown_on;  ///< as in text_of
    std::vector<std::string> unknown;    ///< names of the fields that this program does not know
};

/// The document of a text of text_of or share_text, or one clause on why the text is none: no
/// document, a newer format, or the damage.
std::expected<ParsedDocument, std::string> document_from(std::string_view text);

/// Whether the text looks like a document, or one of share_text, rather than a formula.
bool looks_like_document(std::string_view text);

}  // namespace zeroset
