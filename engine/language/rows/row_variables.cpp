#include "engine/language/rows/row_variables.hpp"

#include <algorithm>

namespace zeroset {

const std::set<const Definition*>& RowVariables::going_by(const std::vector<std::string>& names) {
    const auto [entry, is_new] = going_by_.try_emplace(names);
    if (!is_new) return entry->second;
    entry->second = table_.going_by(names);
    for (const Definition* const definition : entry->second) {
        std::vector<std::string>& known = names_[definition];
        for (const std::string& name : names) {
            if (std::ranges::find(known, name) == known.end()) known.push_back(name);
        }
    }
    return entry->second;
}

const std::vector<std::string>* RowVariables::names_of(const Definition& definition) const {
    const auto found = names_.find(&definition);
    return found == names_.end() ? nullptr : &found->second;
}

}  // namespace zeroset
