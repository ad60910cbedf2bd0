#pragma once

#include "engine/expr/op.hpp"
#include "engine/real/field.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace zeroset {

using NodeId = std::uint32_t;

/// Variables 0 to 2 are x, y, z; variable 3 is w, 4 and up are the parameters.
inline constexpr int variable_w = 3;

/// The longest printed formula, in bytes, that can be read back.
inline constexpr std::size_t longest_text = 100'000;

struct Node {
    Op op = Op::Constant;
    std::int32_t number = 0;  ///< the variable, exponent, degree, factor of the angle, derivative
    NodeId a = 0;             ///< operands; always smaller than the node's own id
    NodeId b = 0;
    NodeId c = 0;
    double lo = 0.0;  ///< the doubles that enclose a constant
    double hi = 0.0;
    std::shared_ptr<const Field> field{};

    bool operator==(const Node&) const = default;
};

/// Bytes that are equal for equal lists of nodes only.
std::string key_of(std::span<const Node> nodes);

/// An expression as a graph in which equal subexpressions are one node. Nodes stand in
/// topological order, operands first; the root is the last. Immutable once built; a value.
class Expr {
public:
    Expr() = default;

    [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
    [[nodiscard]] const Node& node(NodeId id) const { return nodes_[id]; }
    [[nodiscard]] NodeId root() const { return static_cast<NodeId>(nodes_.size() - 1); }
    /// Names of variables 4 and up.
    [[nodiscard]] std::span<const std::string> parameters() const { return parameters_; }
    [[nodiscard]] std::vector<std::string> parameter_names() const { return parameters_; }
    [[nodiscard]] bool uses_variable(int variable) const;
    /// The formula with every operator written out; parsing it gives the same graph unless it is
    /// cut, longer than `longest_text`, or has an operator that is never read, written as what it
    /// stands for.
    [[nodiscard]] std::string canonical() const;
    /// Equal graphs have equal keys.
    [[nodiscard]] std::string key() const;

private:
    friend class ExprBuilder;
    std::vector<Node> nodes_;
    std::vector<std::string> parameters_;
};

/// The fields that the graph asks, each once.
std::vector<std::shared_ptr<const Field>> fields_of(const Expr& expr);

/// Makes the nodes of one Expr, each only once.
class ExprBuilder {
public:
    NodeId constant(double lo, double hi);
    NodeId constant(double exact) { return constant(exact, exact); }
    NodeId variable(int index);
    /// The operator on as many operands as it has; the others are ignored.
    NodeId apply(Op op, NodeId a, NodeId b = 0, NodeId c = 0, int number = 0);
    /// The field, or a derivative of it, at (a, b, c).
    NodeId look_up(std::shared_ptr<const Field> field, NodeId a, NodeId b, NodeId c,
                   int derivative = 0);

    [[nodiscard]] const Node& node(NodeId id) const { return nodes_[id]; }
    [[nodiscard]] std::size_t size() const { return nodes_.size(); }

    /// The graph below `root` as Expr::canonical writes it, cut where it gets longer than
    /// `longest`.
    [[nodiscard]] std::string text(NodeId root, std::span<const std::string> parameters,
                                   std::size_t longest) const;

    /// The graph below `root`, without what it does not use.
    [[nodiscard]] Expr finish(NodeId root, std::vector<std::string> parameters = {}) const;

private:
    struct NodeHash {
        std::size_t operator()(const Node& node) const;
    };

    NodeId intern(const Node& node);

    std::vector<Node> nodes_;
    std::unordered_map<Node, NodeId, NodeHash> known_;
};

/// The equation f = 0 that the graph of f means, with what restricts it. Each of the two is cut
/// where it gets longer than `longest`.
std::string equation_text(const Expr& expr, std::size_t longest = longest_text);

/// "x", "y", "z", "w" or the parameter's name.
std::string_view variable_name(int index, std::span<const std::string> parameters);

}  // namespace zeroset
