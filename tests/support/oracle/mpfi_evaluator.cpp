#include "tests/support/oracle/mpfi_evaluator.hpp"

#include <cstddef>
#include <utility>

namespace zeroset::test {

MpfiEvaluator::MpfiEvaluator(const Expr& expr)
    : expr_(expr), values_(expr.nodes().size()), duals_(expr.nodes().size()) {}

MpfiEnclosure MpfiEvaluator::over(std::span<const MpfiInterval> box) {
    for (std::size_t id = 0; id < values_.size(); ++id) {
        const Node& node = expr_.nodes()[id];
        if (node.op == Op::Constant) {
            values_[id] = {MpfiInterval(node.lo, node.hi)};
        } else if (node.op == Op::Variable) {
            values_[id] = {box[static_cast<std::size_t>(node.number)]};
        } else {
            values_[id] = enclosed(node, values_[node.a], values_[node.b], values_[node.c]);
        }
    }
    return values_.back();
}

MpfiDual MpfiEvaluator::along(std::span<const MpfiDual> variables) {
    for (std::size_t id = 0; id < duals_.size(); ++id) {
        const Node& node = expr_.nodes()[id];
        if (node.op == Op::Constant) {
            duals_[id] = dual(MpfiInterval(node.lo, node.hi), MpfiInterval(0.0));
        } else if (node.op == Op::Variable) {
            duals_[id] = variables[static_cast<std::size_t>(node.number)];
        } else {
            const MpfiDual& a = duals_[node.a];
            const MpfiDual& b = duals_[node.b];
            const MpfiDual& c = duals_[node.c];
            MpfiEnclosure f = enclosed(node, a.value, b.value, c.value);
            MpfiInterval slope = slope_of(node, f, a, b, c);
            duals_[id] = {std::move(f), std::move(slope)};
        }
    }
    return duals_.back();
}

std::vector<MpfiInterval> points(std::span<const double> at) {
    std::vector<MpfiInterval> result;
    for (const double coordinate : at)
        result.emplace_back(coordinate);
    return result;
}

}  // namespace zeroset::test
