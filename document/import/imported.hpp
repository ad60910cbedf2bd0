#pragma once

#include "document/document.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Documents made of other programs' files, and what was not taken over.

namespace zeroset {

/// A thing in a file that was not taken over, or not as it stands there.
struct ImportNote {
    std::size_t line = 0;    ///< from 1; 0: the file as a whole, or a place without a line
    std::string entry = {};  ///< its name in the file; may be empty
    std::string reason;      ///< one line: what it is, and what stands in its place

    bool operator==(const ImportNote&) const = default;
};

/// A document and where its rows come from.
struct ImportedDocument {
    std::string name;  ///< as the file calls it; empty where it does not
    Document document{};
    /// For each row: its line in the file, 0 where there is none, and whether it is a surface.
    std::vector<std::size_t> row_lines = {};
    std::vector<bool> row_draws = {};
    bool tells_box = false;    ///< the clip box is the file's own
    std::string refusal = {};  ///< why it draws nothing; empty where it does
    std::vector<ImportNote> notes = {};

    void note(std::size_t line, std::string_view entry, std::string reason);
    /// Adds a surface's row and returns its statement.
    Statement& add_row(std::string text, std::size_t line,
                       std::optional<std::uint32_t> color = std::nullopt);
    /// Adds a row that draws nothing: a definition or a remark.
    void add_definition(std::string text, std::size_t line);
};

/// The contents of a file.
struct Imported {
    std::vector<ImportedDocument> documents;  ///< at least one
    std::vector<ImportNote> notes = {};       ///< about no single document
};

/// Other files that a text may name.
struct ImportFiles {
    const FieldSource* fields = nullptr;  ///< nullptr: it must not name volumes
    /// The text of a file in the folder of the one that is read, or in those below it; nothing
    /// where there is none.
    std::function<std::optional<std::string>(std::string_view name)> text_beside = {};
};

/// The result of a reader; the error is one line without the file's name, with "line N: " before it
/// where it has a place.
using ReadImport = std::expected<Imported, std::string>;

/// An error of a reader at a line.
std::unexpected<std::string> import_error(std::size_t line, const std::string& reason);

/// Files of more bytes than this are not read as scripts.
inline constexpr std::size_t largest_script = 8U << 20U;
/// A file's further documents are left out, with a note.
inline constexpr std::size_t most_imported = 5000;

/// 0xRRGGBB of channels from 0 to 1 as they show; values beyond are cut off.
std::uint32_t shown_color(double red, double green, double blue);

/// A number with all its digits, as a formula has it: "(-2.5)" where it is negative and `inner`.
std::string exact_number(double value, bool inner = false);

/// Reads the rows of the document as the language does. Rows that it refuses become remarks, each
/// with a note of the reason; where no surface would be left they stay, and `refusal` says why.
/// Definitions that the language takes for surfaces are hidden.
void check_rows(ImportedDocument& imported);

}  // namespace zeroset
