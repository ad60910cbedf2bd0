#pragma once

#include "document/row_program.hpp"
#include "engine/view/box.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

struct Document;

/// A row to be read, with its id in the document.
struct SheetRow {
    int id;
    std::string text;
    std::optional<Box> box = std::nullopt;  ///< that cuts what it draws

    bool operator==(const SheetRow&) const = default;
};
using Sheet = std::vector<SheetRow>;

/// The rows of a document.
Sheet sheet_of(const Document& document);

struct RowError {
    std::string reason;       ///< what is wrong, and what to type instead; one line
    std::size_t at = 0;       ///< offset in the row's text, in bytes; at most its size
    bool unfinished = false;  ///< correct so far, but the row ends too early
    std::optional<Mend> mend = std::nullopt;  ///< of the word at `at`, where one is likely
};

/// The result of reading a row. With an error, it keeps the readings of the row's last good text.
struct RowReport {
    std::string text;  ///< the row's text when it was read
    std::vector<Reading> readings;
    std::optional<RowError> error;
};

/// The result of reading a sheet. Its program has no readings: they are in the reports.
struct SheetReading : RowProgram {
    std::map<int, RowReport> reports;  ///< by id of the row
};

/// Reads sheets while they are edited. A row with an error does not keep the others from being
/// read: its last text without an error replaces it, or nothing.
class SheetReader {
public:
    /// `files`: where the files that rows name come from; nullptr: they must not name any.
    /// `draws_old`: whether the last good text of a wrong row is drawn. Without it those that draw
    /// something are forgotten; definitions still stand in, as others may need them.
    SheetReading read(const Sheet& sheet, const std::shared_ptr<const FieldSource>& files = nullptr,
                      bool draws_old = true);

private:
    struct GoodText {
        std::string text;
        bool draws = false;  ///< it has a surface
    };
    void keep_good(const Sheet& sheet, const std::vector<std::string>& texts,
                   const std::vector<int>& surface_rows);

    std::map<int, GoodText> good_;  ///< the last good text of each row ever read, by id
};

}  // namespace zeroset
