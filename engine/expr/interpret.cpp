#include "engine/expr/interpret.hpp"

#include "engine/expr/algebra.hpp"
#include "engine/expr/facts.hpp"

#include <cassert>
#include <memory>

namespace zeroset {
namespace {

struct Program {
    Expr expr;
    std::vector<Facts> facts;
};

const Program& program(const void* code) { return *static_cast<const Program*>(code); }

constexpr auto nothing = [] {};

void range_of_box(const Program& code, const RangeBatch& batch, std::size_t i) {
    IntervalAlgebra<float> algebra;
    const auto leaf = [&](const Node& node, const Facts& facts) -> Interval<float> {
        if (facts.constant) {
            return {float_above(facts.constant->neg_lo), float_above(facts.constant->hi)};
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v < 3) return {batch.neg_lo[v][i], batch.hi[v][i]};
        return {batch.uniforms[2 * (v - 3)], batch.uniforms[2 * (v - 3) + 1]};
    };
    const Interval<float> f = evaluate(code.expr, code.facts, algebra, leaf, nothing);
    const float nowhere = -static_cast<float>(infinity);
    const bool defined = algebra.defined.value_or(true);
    batch.f_neg_lo[i] = defined ? f.neg_lo : nowhere;
    batch.f_hi[i] = defined ? f.hi : nowhere;
    batch.continuous[i] = algebra.continuous.value_or(true) ? ~0U : 0U;
}

void interpret_range(const void* code, const RangeBatch* batch) {
    for (std::size_t i = 0; i < batch->size; ++i)
        range_of_box(program(code), *batch, i);
}

void interpret_value(const void* code, const ValueBatch* batch) {
    for (std::size_t i = 0; i < batch->size; ++i) {
        DualAlgebra<float> algebra;
        const auto leaf = [&](const Node& node, const Facts& facts) -> Dual<float> {
            if (facts.constant) return {facts.middle_float, {}};
            const auto v = static_cast<std::size_t>(node.number);
            if (v >= 3) return {batch->uniforms[v - 3], {}};
            Dual<float> variable{batch->x[v][i], {}};
            variable.slope[v] = 1.0F;
            return variable;
        };
        const Dual<float> f =
            evaluate(program(code).expr, program(code).facts, algebra, leaf, nothing);
        batch->f[i] = f.value;
        for (std::size_t k = 0; k < 3; ++k)
            batch->gradient[k][i] = f.slope[k].value_or(0.0F);
    }
}

}  // namespace

Kernel kernel_without_code(const Expr& expr) {
    Kernel kernel;
    kernel.parameters.assign(expr.parameters().begin(), expr.parameters().end());
    kernel.uses_w = expr.uses_variable(variable_w);
    return kernel;
}

Kernel interpret(const Expr& expr) {
    Kernel kernel = kernel_without_code(expr);
    kernel.range_function = interpret_range;
    kernel.value_function = interpret_value;
    kernel.code = std::make_shared<Program>(Program{expr, facts_of(expr)});
    return kernel;
}

Dual<double> value_at(const Expr& expr, const std::array<double, 4>& at) {
    const std::vector<Facts> facts = facts_of(expr);
    DualAlgebra<double> algebra;
    const auto leaf = [&](const Node& node, const Facts& fact) -> Dual<double> {
        if (fact.constant) return {fact.middle, {}};
        const auto v = static_cast<std::size_t>(node.number);
        Dual<double> variable{v < at.size() ? at[v] : 1.0, {}};
        if (v < 3) variable.slope[v] = 1.0;
        return variable;
    };
    return evaluate(expr, facts, algebra, leaf, nothing);
}

}  // namespace zeroset
