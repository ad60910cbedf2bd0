#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace zeroset {

/// Whether a document may have a slider of this name: the language takes it for a parameter.
bool can_have_slider(std::string_view name);

/// Names of another program's script as the language can define them.
class ImportedNames {
public:
    /// A name that no other thing has: the given one where the language can define it, else one
    /// like it. Each call gives another.
    std::string fresh(std::string_view wanted);

private:
    std::set<std::string, std::less<>> taken_;
    std::map<std::string, int, std::less<>> next_;  ///< numbers to be tried behind names
};

}  // namespace zeroset
