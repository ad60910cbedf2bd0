#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Mathematica's lists that are written by an index.

namespace zeroset {

/// Table[body, {k, 1, 3}, ...]: what stands in place of the indices in each of its terms.
struct Table {
    using Term = std::vector<std::pair<std::string_view, std::string>>;

    std::string_view body;
    std::vector<Term> terms;
};

/// The table from what is in its brackets; nothing where an index has no numbers as ends, or where
/// there are more than a hundred terms.
std::optional<Table> table_of(std::string_view inside);
/// The table that an expression is, perhaps within Evaluate[...].
std::optional<Table> table_in(std::string_view expression);

}  // namespace zeroset
