#include "engine/interpret/interpret.hpp"

#include "engine/algebra/algebra.hpp"
#include "engine/algebra/graph_facts.hpp"
#include "engine/interpret/interpret_code.hpp"
#include "engine/kernel/float_check.hpp"
#include "engine/kernel/union_parts.hpp"
#include "engine/real/block.hpp"
#include "engine/tape/tape.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace zeroset {
namespace {

/// A pointer that keeps nothing alive, and costs nothing to copy.
template <class Object>
std::shared_ptr<const Object> unowned(const Object& object) {
    return {std::shared_ptr<const Object>(), &object};
}

class TapeSpecializer : public Specializer {
public:
    explicit TapeSpecializer(std::shared_ptr<const Tape> tape) : tape_(std::move(tape)) {}

    void form(const FormBatchOf<float>& batch, ChoiceRecord& record) const override {
        size_record(batch, record);
        interpreter_code().in_float.record(*tape_, batch, record);
    }
    void form(const FormBatchOf<double>& batch, ChoiceRecord& record) const override {
        size_record(batch, record);
        interpreter_code().in_double.record(*tape_, batch, record);
    }
    [[nodiscard]] std::shared_ptr<const Kernel> specialized(
        const ChoiceRecord& record, std::span<const std::size_t> cells) const override;

private:
    template <class Real>
    void size_record(const FormBatchOf<Real>& batch, ChoiceRecord& record) const {
        record.lanes = block_bytes / sizeof(Real);
        record.choices = tape_->choices();
        record.bits.resize(batch.size / record.lanes * record.choices);
    }

    std::shared_ptr<const Tape> tape_;
};

void set_code(Kernel& kernel, const std::shared_ptr<const Tape>& tape) {
    const InterpreterCode& code = interpreter_code();
    visit_functions([&tape](auto& function, auto call) { function = {call, tape}; }, kernel, code);
    kernel.has_double = true;
    kernel.interpreted = true;
    kernel.steps = tape->steps().size();
    kernel.switches = tape->graph()->switch_count;
    kernel.branches = true;
}

/// A tape and its kernel in one piece: thousands are made for a frame.
struct TapeKernel {
    explicit TapeKernel(Tape code) : tape(std::move(code)), specializer(unowned(tape)) {
        set_code(kernel, unowned(tape));
        if (tape.choices() > 0) kernel.specializer = unowned<Specializer>(specializer);
    }
    TapeKernel(const TapeKernel&) = delete;
    TapeKernel& operator=(const TapeKernel&) = delete;
    ~TapeKernel() = default;

    Tape tape;
    TapeSpecializer specializer;
    Kernel kernel;
};

std::shared_ptr<const Kernel> TapeSpecializer::specialized(
    const ChoiceRecord& record, std::span<const std::size_t> cells) const {
    auto tape = tape_->specialized(record, cells);
    if (!tape) return nullptr;
    const auto& graph = tape->graph();
    if (const auto part = tape->part(tape->root()); part != Parts::none)
        return {graph, &graph->part_kernels[part]};
    const auto made = std::make_shared<const TapeKernel>(std::move(*tape));
    return {made, &made->kernel};
}

/// Nothing where there are not several.
std::optional<UnionParts> operands_of_least(const std::shared_ptr<const TapeGraph>& graph) {
    const std::vector<NodeId> nodes = graph->union_parts();
    if (nodes.size() < 2) return std::nullopt;
    std::vector<const Kernel*> kernels;
    std::vector<std::shared_ptr<const void>> owners{graph};
    for (const NodeId node : nodes) {
        if (const auto part = graph->parts.of_node[node]; part != Parts::none) {
            kernels.push_back(&graph->part_kernels[part]);
            continue;
        }
        const auto made = std::make_shared<const TapeKernel>(Tape(graph, node));
        kernels.push_back(&made->kernel);
        owners.push_back(made);
    }
    return std::optional<UnionParts>(std::in_place, std::move(kernels), std::move(owners));
}

/// Specializes the kernel of a whole formula.
class WholeSpecializer final : public TapeSpecializer {
public:
    explicit WholeSpecializer(const std::shared_ptr<const Tape>& tape)
        : TapeSpecializer(tape), union_parts_(operands_of_least(tape->graph())) {}

    [[nodiscard]] const UnionParts* union_parts() const override {
        return union_parts_ ? &*union_parts_ : nullptr;
    }

private:
    std::optional<UnionParts> union_parts_;
};

/// Whether the operator takes usual numbers out of the range of float.
bool may_leave_range(const Node& node) {
    constexpr int high_power = 6;
    constexpr double large = 1e12;
    const auto unusual = [](double x) {
        const double size = std::abs(x);
        return size > large || (size > 0.0 && size < 1.0 / large);
    };
    if (node.op == Op::Constant) return unusual(node.lo) || unusual(node.hi);
    if (node.op == Op::IntPower) return node.number >= high_power;
    return node.op == Op::Exp || node.op == Op::Sinh || node.op == Op::Cosh;
}

}  // namespace

Kernel interpret(const Expr& expr) { return interpret(expr, facts_of(expr), {}); }

Kernel interpret(const Expr& expr, std::vector<Facts> facts, Parts parts) {
    Kernel kernel;
    kernel.parameters.assign(expr.parameters().begin(), expr.parameters().end());
    kernel.uses_w = expr.uses_variable(variable_w);
    const auto tape = std::make_shared<const Tape>(
        std::make_shared<const TapeGraph>(expr, std::move(facts), std::move(parts)));
    set_code(kernel, tape);
    if (std::ranges::any_of(expr.nodes(), may_leave_range))
        kernel.float_check = std::make_shared<const FloatCheck>(kernel);
    if (tape->choices() > 0) kernel.specializer = std::make_shared<WholeSpecializer>(tape);
    return kernel;
}

PointFunction interpret_points(const Expr& expr) {
    return {.call = interpreter_code().points,
            .code = std::make_shared<const Tape>(
                std::make_shared<const TapeGraph>(expr, facts_of(expr), Parts{}))};
}

Dual<double> value_at(const Expr& expr, const std::array<double, 4>& at,
                      std::span<const double> parameters) {
    const std::vector<Facts> facts = facts_of(expr);
    DualAlgebra<double> algebra;
    const auto leaf = [&](const Node& node, const Facts& fact) -> Dual<double> {
        if (fact.constant) return {.value = fact.middle, .slope = {}};
        const auto v = static_cast<std::size_t>(node.number);
        const std::size_t p = v - at.size();
        const double given = p < parameters.size() ? parameters[p] : 1.0;
        Dual<double> variable{.value = v < at.size() ? at[v] : given, .slope = {}};
        if (v < 3) variable.slope.set(v, 1.0);
        return variable;
    };
    return evaluate(expr, facts, algebra, leaf, [] {});
}

}  // namespace zeroset
