#pragma once

#include "engine/language/expressions/free_names.hpp"
#include "engine/language/values/graph_values.hpp"

#include <span>
#include <string>

namespace zeroset {

/// Writes values as readings have them, each number of them cut where it is long.
class ReadingText {
public:
    /// All definitions of a text share the length of readings. `values` and `names` outlive this
    /// object.
    ReadingText(const GraphValues& values, const FreeNames& names, std::size_t definitions);

    [[nodiscard]] std::string of(NodeId id) const { return of(id, names_.parameters()); }
    /// With names for all variables behind w.
    [[nodiscard]] std::string of(NodeId id, std::span<const std::string> names) const {
        return values_.builder().text(id, names, longest_);
    }
    [[nodiscard]] std::string of(const BuiltValue& value) const {
        return of(value, names_.parameters());
    }
    [[nodiscard]] std::string of(const BuiltValue& value, std::span<const std::string> names) const;

private:
    const GraphValues& values_;
    const FreeNames& names_;
    std::size_t longest_;  ///< bytes
};

}  // namespace zeroset
