#include "engine/expr/interpret.hpp"

#include "engine/expr/algebra.hpp"
#include "engine/expr/facts.hpp"
#include "engine/expr/frustum.hpp"
#include "engine/expr/ray_functions.hpp"
#include "engine/expr/slots.hpp"
#include "engine/num/block.hpp"

#include <cstring>
#include <memory>
#include <new>
#include <type_traits>

namespace zeroset {
namespace {

static_assert(batch_multiple % Block<float>::lanes == 0 &&
              batch_multiple % Block<double>::lanes == 0);

struct Program {
    Expr expr;
    std::vector<Facts> facts;
    Slots slots;

    explicit Program(const Expr& graph)
        : expr(graph), facts(facts_of(graph)), slots(assign_slots(graph, facts)) {}
};

/// This thread's room for the values of a graph, kept from call to call.
template <class Value>
std::vector<Value>& scratch(std::size_t slots) {
    thread_local std::vector<Value> values;
    if (values.size() < slots) values.resize(slots);
    return values;
}

template <class Real>
Block<Real> load(const Real* lanes) {
    Block<Real> block;
    std::memcpy(&block, lanes, sizeof block);
    return block;
}
template <class Real>
void store(Real* lanes, const Block<Real>& block) {
    std::memcpy(lanes, &block, sizeof block);
}

/// All ones where the mask holds.
template <class Real>
void store(ContinuityMask<Real>* items, const std::optional<BlockMask>& mask, bool if_absent) {
    const unsigned bits = mask ? mask->bits : (if_absent ? ~0U : 0U);
    const auto all_ones = static_cast<ContinuityMask<Real>>(-1);
    for (std::size_t lane = 0; lane < Block<Real>::lanes; ++lane)
        items[lane] = (bits >> lane & 1U) != 0 ? all_ones : 0U;
}

/// Evaluates the graph over `size` items by blocks of some lanes. `leaf(node, facts, item)` makes
/// the value of a variable or a constant subexpression, for a uniform one whatever the item;
/// `finish(root, item)` takes the results.
template <class Algebra, std::size_t lanes, class Leaf, class Finish>
void interpret_blocks(const Program& code, std::size_t size, Leaf leaf, Finish finish) {
    using Value = typename Algebra::Value;
    static_assert(std::is_trivially_destructible_v<Value>);
    Algebra algebra;
    std::vector<Value>& values = scratch<Value>(code.slots.count);
    const auto compute = [&](NodeId id, std::size_t item) {
        const Node& node = code.expr.node(id);
        const Facts& facts = code.facts[id];
        Value* const value = &values[code.slots.of[id]];
        const auto operand = [&](NodeId k) {
            return Operand<Value>{values[code.slots.of[k]], code.facts[k]};
        };
        // Made in its place, which no operand has: copying would cost as much as computing.
        if (is_leaf(node, facts)) {
            new (value) Value(leaf(node, facts, item));
        } else {
            new (value) Value(apply_to(algebra, node, operand));
        }
    };
    const NodeId root = code.expr.root();
    for (NodeId id = 0; id <= root; ++id) {
        if (code.facts[id].uniform) compute(id, 0);
    }
    for (std::size_t item = 0; item < size; item += lanes) {
        for (NodeId id = 0; id <= root; ++id) {
            if (!code.facts[id].uniform) compute(id, item);
        }
        finish(values[code.slots.of[root]], item);
    }
}

template <class Real>
void interpret_range(const void* code, const RangeBatchOf<Real>* batch) {
    using Lanes = Block<Real>;
    const auto leaf = [&](const Node& node, const Facts& facts, std::size_t i) -> Enclosure<Lanes> {
        if (facts.constant) {
            const auto box = facts.constant_box<Real>();
            return {{Lanes::splat(box.neg_lo), Lanes::splat(box.hi)}};
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v < 3) return {{load(batch->neg_lo[v] + i), load(batch->hi[v] + i)}};
        return {{Lanes::splat(batch->uniforms[2 * (v - 3)]),
                 Lanes::splat(batch->uniforms[2 * (v - 3) + 1])}};
    };
    const auto finish = [&](const Enclosure<Lanes>& f, std::size_t i) {
        const Interval<Lanes> range = answer(f);
        store(batch->f_neg_lo + i, range.neg_lo);
        store(batch->f_hi + i, range.hi);
        store<Real>(batch->continuous + i, conjunction(f.everywhere, f.continuous), true);
    };
    interpret_blocks<IntervalAlgebra<Lanes>, Lanes::lanes>(*static_cast<const Program*>(code),
                                                           batch->size, leaf, finish);
}

template <class Real>
void interpret_form(const void* code, const FormBatchOf<Real>* batch) {
    using Lanes = Block<Real>;
    const auto view = frustum_lanes<Lanes>(
        [&](std::size_t index) { return Lanes::splat(batch->frustum[index]); });
    const auto leaf = [&](const Node& node, const Facts& facts, std::size_t i) -> BeamValue<Lanes> {
        if (facts.constant) {
            return constant_form<Lanes>(facts, Real{}, [](Real x) { return Lanes::splat(x); });
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v >= 3) {
            return uniform_form<Lanes>({Lanes::splat(batch->uniforms[2 * (v - 3)]),
                                        Lanes::splat(batch->uniforms[2 * (v - 3) + 1])});
        }
        return coordinate<Lanes>(
            view,
            {load(batch->u + i), load(batch->v + i), load(batch->s + i), load(batch->s_radius + i)},
            v);
    };
    const auto finish = [&](const BeamValue<Lanes>& f, std::size_t i) {
        const FormResult<Lanes> result = form_result(f);
        store(batch->c + i, result.c);
        for (std::size_t k = 0; k < 3; ++k)
            store(batch->k[k] + i, result.k[k]);
        store(batch->e + i, result.e);
        store(batch->r + i, result.r);
        store(batch->slope_neg_lo + i, result.slope.neg_lo);
        store(batch->slope_hi + i, result.slope.hi);
        store<Real>(batch->continuous + i, result.continuous, true);
        std::optional<BlockMask> nowhere = result.somewhere;
        if (nowhere) nowhere = no(*nowhere);
        store<Real>(batch->nowhere + i, nowhere, false);
    };
    interpret_blocks<BeamAlgebra<Lanes>, Lanes::lanes>(*static_cast<const Program*>(code),
                                                       batch->size, leaf, finish);
}

template <class Real>
void interpret_value(const void* code, const ValueBatchOf<Real>* batch) {
    using Lanes = Block<Real>;
    const auto leaf = [&](const Node& node, const Facts& facts, std::size_t i) -> Dual<Lanes> {
        if (facts.constant) return {Lanes::splat(facts.constant_point<Real>()), {}};
        const auto v = static_cast<std::size_t>(node.number);
        if (v >= 3) return {Lanes::splat(batch->uniforms[v - 3]), {}};
        Dual<Lanes> variable{load(batch->x[v] + i), {}};
        variable.slope[v] = Lanes::splat(1);
        return variable;
    };
    const auto finish = [&](const Dual<Lanes>& f, std::size_t i) {
        store(batch->f + i, f.value);
        for (std::size_t k = 0; k < 3; ++k)
            store(batch->gradient[k] + i, f.slope[k].value_or(Lanes::splat(0)));
    };
    interpret_blocks<DualAlgebra<Lanes>, Lanes::lanes>(*static_cast<const Program*>(code),
                                                       batch->size, leaf, finish);
}

}  // namespace

Kernel interpret(const Expr& expr) {
    const std::shared_ptr<const void> code = std::make_shared<Program>(expr);
    Kernel kernel;
    kernel.parameters.assign(expr.parameters().begin(), expr.parameters().end());
    kernel.uses_w = expr.uses_variable(variable_w);
    kernel.range_float = {interpret_range<float>, code};
    kernel.value_float = {interpret_value<float>, code};
    kernel.form_float = {interpret_form<float>, code};
    kernel.ray_form_float = kernel.form_float;
    kernel.range_double = {interpret_range<double>, code};
    kernel.value_double = {interpret_value<double>, code};
    kernel.form_double = {interpret_form<double>, code};
    kernel.ray_form_double = kernel.form_double;
    kernel.has_double = true;
    add_ray_functions(kernel);
    return kernel;
}

Dual<double> value_at(const Expr& expr, const std::array<double, 4>& at,
                      std::span<const double> parameters) {
    const std::vector<Facts> facts = facts_of(expr);
    DualAlgebra<double> algebra;
    const auto leaf = [&](const Node& node, const Facts& fact) -> Dual<double> {
        if (fact.constant) return {fact.middle, {}};
        const auto v = static_cast<std::size_t>(node.number);
        const std::size_t p = v - at.size();
        const double given = p < parameters.size() ? parameters[p] : 1.0;
        Dual<double> variable{v < at.size() ? at[v] : given, {}};
        if (v < 3) variable.slope[v] = 1.0;
        return variable;
    };
    return evaluate(expr, facts, algebra, leaf, [] {});
}

}  // namespace zeroset
