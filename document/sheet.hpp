#pragma once

#include "document/row_program.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// The rows to be read, in order, by their ids in the document.
struct SheetRow {
    int id;
    std::string text;

    bool operator==(const SheetRow&) const = default;
};
using Sheet = std::vector<SheetRow>;

struct RowError {
    std::string reason;       ///< what is wrong, and what to type instead; one line
    std::size_t at = 0;       ///< in bytes of the row's text, at most its size
    bool unfinished = false;  ///< right so far, but the row stops too early
};

/// How a row was understood. A row with an error keeps the readings of its last good text.
struct RowReport {
    std::string text;  ///< of the row, when it was read
    std::vector<Reading> readings;
    std::optional<RowError> error;
};

/// What a sheet says. Its program has no readings: they are in the reports.
struct SheetReading : RowProgram {
    std::map<int, RowReport> reports;  ///< by row
};

/// Reads sheets as they are edited. A row with an error does not keep the others from being read:
/// its last text without an error stands in for it, or nothing.
class SheetReader {
public:
    SheetReading read(const Sheet& sheet);

private:
    std::map<int, std::string> good_;  ///< of each row that was ever read
};

}  // namespace zeroset
