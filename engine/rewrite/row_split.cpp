#include "engine/rewrite/row_split.hpp"

#include "engine/expr/copy.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace zeroset {
namespace {

/// The coordinates that a value depends on, as bits.
using Coordinates = std::uint8_t;
constexpr Coordinates along_x = 1;
constexpr Coordinates across_x = 6;

/// About how long an operator takes, in additions.
int cost_of(Op op) {
    constexpr std::array free{Op::Constant, Op::Variable};
    constexpr std::array quick{Op::Negate, Op::Add,  Op::Subtract,  Op::Multiply, Op::IntPower,
                               Op::Abs,    Op::Min,  Op::Max,       Op::Sqrt,     Op::Divide,
                               Op::If,     Op::Less, Op::LessEqual, Op::Where};
    if (std::ranges::find(free, op) != free.end()) return 0;
    return std::ranges::find(quick, op) != quick.end() ? 1 : 10;
}

/// The values of a graph that are computed less often than at each point.
class RowValues {
public:
    explicit RowValues(const Expr& f) : f_(f) {
        for (const Node& node : f.nodes()) {
            Coordinates depends = 0;
            if (node.op == Op::Variable && node.number < variable_w)
                depends = static_cast<Coordinates>(1U << static_cast<unsigned>(node.number));
            each_operand(node, [&](NodeId operand) { depends |= depends_[operand]; });
            depends_.push_back(depends);
        }
        std::vector<bool> used(f.nodes().size());
        used[f.root()] = true;
        for (NodeId id = 0; id <= f.root(); ++id) {
            if (is_mixed(id))
                each_operand(f.node(id), [&](NodeId operand) { used[operand] = true; });
        }
        for (NodeId id = 0; id < used.size(); ++id) {
            if (!used[id] || is_mixed(id) || depends_[id] == 0) continue;
            (depends_[id] == along_x ? of_x_ : of_row_).push_back(id);
        }
        choose_tables();
    }

    [[nodiscard]] std::span<const NodeId> of_x() const { return of_x_; }
    [[nodiscard]] std::span<const NodeId> of_row() const { return of_row_; }

private:
    [[nodiscard]] bool is_mixed(NodeId id) const {
        return (depends_[id] & along_x) != 0 && (depends_[id] & across_x) != 0;
    }
    [[nodiscard]] int cost_below(NodeId root) const {
        int cost = 0;
        for (const NodeId id : nodes_below(f_, root))
            cost += cost_of(f_.node(id).op);
        return cost;
    }
    /// Where there are more functions of x than tables: x itself and the costliest.
    void choose_tables() {
        if (of_x_.size() <= RowSplit::most_tables) return;
        std::vector<std::pair<int, NodeId>> costs;
        NodeId x = 0;
        for (NodeId id = 0; id < depends_.size(); ++id) {
            if (f_.node(id).op == Op::Variable && f_.node(id).number == 0) x = id;
        }
        for (const NodeId id : of_x_) {
            if (id != x) costs.emplace_back(-cost_below(id), id);
        }
        std::ranges::sort(costs);
        of_x_ = {x};
        for (std::size_t i = 0; i + 1 < RowSplit::most_tables; ++i)
            of_x_.push_back(costs[i].second);
    }

    const Expr& f_;
    std::vector<Coordinates> depends_;
    std::vector<NodeId> of_x_, of_row_;
};

}  // namespace

RowSplit split_for_rows(const Expr& f) {
    const RowValues values(f);
    RowSplit split;
    ExprBuilder builder;
    std::vector<NodeId> copies(f.nodes().size());
    std::vector<bool> is_made(f.nodes().size());
    const auto put = [&](NodeId id, int variable) {
        copies[id] = builder.variable(variable);
        is_made[id] = true;
    };
    for (const NodeId id : values.of_x()) {
        put(id, static_cast<int>(split.tables.size()));
        split.tables.push_back(graph_below(f, id));
    }
    std::vector<std::string> parameters = f.parameter_names();
    for (const NodeId id : values.of_row()) {
        put(id, variable_w + 1 + static_cast<int>(parameters.size()));
        parameters.push_back("row" + std::to_string(split.of_row.size()));
        split.of_row.push_back(graph_below(f, id));
    }
    for (NodeId id = 0; id < f.nodes().size(); ++id) {
        if (!is_made[id]) copies[id] = copy_node(builder, f.node(id), copies);
    }
    split.along = builder.finish(copies.back(), std::move(parameters));
    return split;
}

}  // namespace zeroset
