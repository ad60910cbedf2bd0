#include "engine/expr/expr.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstring>

namespace zeroset {

std::string_view variable_name(int index, std::span<const std::string> parameters) {
    static constexpr std::array<std::string_view, 4> fixed{"x", "y", "z", "w"};
    const auto i = static_cast<std::size_t>(index);
    return i < fixed.size() ? fixed[i] : std::string_view(parameters[i - fixed.size()]);
}

bool Expr::uses_variable(int variable) const {
    return std::ranges::any_of(nodes_, [&](const Node& node) {
        return node.op == Op::Variable && node.number == variable;
    });
}

std::vector<std::shared_ptr<const Field>> fields_of(const Expr& expr) {
    std::vector<std::shared_ptr<const Field>> fields;
    for (const Node& node : expr.nodes()) {
        if (node.field && std::ranges::find(fields, node.field) == fields.end())
            fields.push_back(node.field);
    }
    return fields;
}

std::string key_of(std::span<const Node> nodes) {
    std::string key;
    key.reserve(nodes.size() * sizeof(Node));
    const auto append = [&key](const auto& value) {
        key.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    for (const Node& node : nodes) {
        append(node.op);
        append(node.number);
        append(node.a);
        append(node.b);
        append(node.c);
        append(node.lo);
        append(node.hi);
        append(node.field ? node.field->id() : 0);
    }
    return key;
}

std::string Expr::key() const {
    std::string key = key_of(nodes_);
    for (const std::string& name : parameters_)
        key += name + ' ';
    return key;
}

std::size_t ExprBuilder::NodeHash::operator()(const Node& node) const {
    std::size_t hash = static_cast<std::size_t>(node.op);
    const auto mix = [&hash](std::uint64_t value) {
        hash = (hash ^ value) * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 29U;
    };
    mix(static_cast<std::uint32_t>(node.number));
    mix((static_cast<std::uint64_t>(node.a) << 32U) | node.b);
    mix(node.c);
    mix(std::bit_cast<std::uint64_t>(node.lo + 0.0));  // -0 and 0 compare equal
    mix(std::bit_cast<std::uint64_t>(node.hi + 0.0));
    if (node.field) mix(node.field->id());
    return hash;
}

NodeId ExprBuilder::intern(const Node& node) {
    const auto [entry, is_new] = known_.try_emplace(node, static_cast<NodeId>(nodes_.size()));
    if (is_new) nodes_.push_back(node);
    return entry->second;
}

NodeId ExprBuilder::constant(double lo, double hi) {
    assert(lo <= hi);
    return intern({.op = Op::Constant, .lo = lo + 0.0, .hi = hi + 0.0});
}

NodeId ExprBuilder::variable(int index) { return intern({.op = Op::Variable, .number = index}); }

NodeId ExprBuilder::apply(Op op, NodeId a, NodeId b, NodeId c, int number) {
    assert(a < nodes_.size() && b < nodes_.size() && c < nodes_.size());
    const int operands = arity(op);
    return intern({.op = op,
                   .number = number,
                   .a = a,
                   .b = operands >= 2 ? b : 0,
                   .c = operands >= 3 ? c : 0});
}

NodeId ExprBuilder::look_up(std::shared_ptr<const Field> field, NodeId a, NodeId b, NodeId c,
                            int derivative) {
    assert(field && a < nodes_.size() && b < nodes_.size() && c < nodes_.size());
    return intern(
        {.op = Op::Field, .number = derivative, .a = a, .b = b, .c = c, .field = std::move(field)});
}

Expr ExprBuilder::finish(NodeId root, std::vector<std::string> parameters) const {
    // Numbered in the order in which the formula is read, left operands first, so that equal
    // graphs have equal keys however they were built.
    constexpr NodeId unplaced = ~NodeId{0};
    Expr expr;
    std::vector<NodeId> number(nodes_.size(), unplaced);
    std::vector<NodeId> stack{root};
    while (!stack.empty()) {
        const NodeId id = stack.back();
        Node node = nodes_[id];
        const std::array operands{&node.a, &node.b, &node.c};
        const auto end = operands.begin() + arity(node.op);
        const auto waits_for = std::find_if(operands.begin(), end, [&](const NodeId* operand) {
            return number[*operand] == unplaced;
        });
        if (waits_for != end) {
            stack.push_back(**waits_for);
            continue;
        }
        stack.pop_back();
        if (number[id] != unplaced) continue;
        std::for_each(operands.begin(), end, [&](NodeId* operand) { *operand = number[*operand]; });
        number[id] = static_cast<NodeId>(expr.nodes_.size());
        expr.nodes_.push_back(node);
    }
    expr.parameters_ = std::move(parameters);
    return expr;
}

}  // namespace zeroset
