#pragma once

#include "engine/expr/expr.hpp"

#include <array>
#include <cstddef>
#include <expected>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// The nodes of an implicit function of 3MF [3MF], written one after the other, each once.
class FunctionNodes {
public:
    /// The output of a node, "name.output".
    using Output = std::string;

    /// Begins with the coordinates of the input "pos".
    FunctionNodes();

    Output constant(double value);
    [[nodiscard]] const Output& coordinate(int axis) const {
        return coordinates_[static_cast<std::size_t>(axis)];
    }
    /// The node `kind` of these inputs, which it calls A, B, C and D.
    Output node(std::string_view kind, std::initializer_list<Output> inputs);

    /// Adds the graph of a formula; an error is one line. `values`: of w and the parameters.
    std::expected<Output, std::string> add(const Expr& expr, std::span<const double> values);

    /// The nodes as XML with the prefix "i".
    [[nodiscard]] const std::string& xml() const { return xml_; }
    [[nodiscard]] std::size_t count() const { return count_; }

private:
    struct Operands {
        Output a, b, c;
    };

    /// A constant, a coordinate, or the value of another variable.
    std::expected<Output, std::string> leaf(const Node& given, std::span<const double> values);
    Output of_operator(const Node& given, const Operands& operands);
    Output of_function(const Node& given, const Output& a, const Output& b);
    Output of_condition(Op op, const Output& a, const Output& b);
    Output power(const Output& base, int exponent);
    Output odd_root(const Output& a, int degree);
    Output inverse_hyperbolic(Op op, const Output& a);
    /// 1 where a is above 0, 0 elsewhere.
    Output truth(const Output& a);
    std::string fresh_name();

    std::string xml_;
    std::array<Output, 3> coordinates_;
    std::map<std::string, Output, std::less<>> known_;  ///< by kind and inputs
    std::size_t count_ = 0;
};

}  // namespace zeroset
