#pragma once

#include "engine/image/background.hpp"
#include "pipeline/file_access.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/prepare.hpp"

#include <memory>
#include <optional>
#include <string>

namespace zeroset {

/// A requested document with the options for view, colours and solids applied.
struct InputDocument : ReadDocument {
    std::string path = {};  ///< of the document's file; empty: it has none
    std::string note = {};  ///< LoadedDocument::note of the file
    /// LoadedDocument::shown_on of the file, which its document has as its background.
    std::optional<Background> shown_on = std::nullopt;
    bool stored = false;  ///< it was kept as a document, with what is shown about its surfaces
    bool typed = false;   ///< it is a text, as argument or on standard input
};

/// The document that the command line's EQUATION names or is: a formula, @NAME of the gallery, a
/// file, a shared session, or - for standard input; without the view options. Notes about another
/// program's file go to stderr.
OrInputError<InputDocument> stored_document(const std::string& equation,
                                            const std::shared_ptr<FileAccess>& access);

}  // namespace zeroset
