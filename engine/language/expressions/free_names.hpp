#pragma once

#include "engine/language/values/graph_values.hpp"

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace zeroset {

/// The names that a text uses and does not define: built-in values and parameters.
class FreeNames {
public:
    explicit FreeNames(GraphValues& values) : values_(values) {}

    /// A built-in value: x, theta, pi, ...
    NodeId built_in(std::string_view name);
    /// A built-in value that the text says; remembers by which name it calls w.
    GraphValues::Built said(std::string_view name, std::size_t offset);
    /// The parameter of a name, a new one if need be; an error if there are too many.
    GraphValues::Built parameter(const std::string& name, std::size_t offset);

    /// In the order of their first uses, which is that of their variables.
    [[nodiscard]] const std::vector<std::string>& parameters() const { return parameters_; }
    [[nodiscard]] bool has_parameter(const std::string& name) const {
        return index_.contains(name);
    }
    /// Whether the text says t for the fourth coordinate, and never w.
    [[nodiscard]] bool calls_w_t() const { return says_t_ && !says_w_; }

private:
    void note_other_meaning(const std::string& name, std::size_t offset);

    GraphValues& values_;
    std::unordered_map<std::string, std::size_t> index_;
    std::vector<std::string> parameters_;
    bool says_w_ = false;
    bool says_t_ = false;
};

}  // namespace zeroset
