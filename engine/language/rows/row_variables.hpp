#pragma once

#include "engine/language/expressions/definition_table.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace zeroset {

/// Which definitions go by the variables of rows: r = 2 + cos v by the v of a row with a range of
/// v.
class RowVariables {
public:
    explicit RowVariables(DefinitionTable& table) : table_(table) {}

    /// The definitions that go by variables of these names, from now on `names_of` them; valid as
    /// long as this object.
    const std::set<const Definition*>& going_by(const std::vector<std::string>& names);
    /// The names of all variables of rows that a definition goes by; nullptr: of none.
    [[nodiscard]] const std::vector<std::string>* names_of(const Definition& definition) const;

private:
    DefinitionTable& table_;
    std::map<std::vector<std::string>, std::set<const Definition*>> going_by_;
    std::map<const Definition*, std::vector<std::string>> names_;
};

}  // namespace zeroset
