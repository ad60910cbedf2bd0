#include "engine/expr/interpret.hpp"

#include "engine/expr/algebra.hpp"
#include "engine/expr/facts.hpp"
#include "engine/expr/frustum.hpp"
#include "engine/expr/ray_functions.hpp"
#include "engine/expr/tape.hpp"
#include "engine/num/block.hpp"

#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace zeroset {
namespace {

static_assert(batch_multiple % Block<float>::lanes == 0 &&
              batch_multiple % Block<double>::lanes == 0);

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

/// Takes note of nothing.
struct NoNotes {
    template <class Values>
    void operator()(const Tape::Step& /*step*/, std::size_t /*item*/, const Values& /*of*/) const {}
};

/// Evaluates the tape over `size` items by blocks of some lanes. `leaf(node, facts, item)` makes
/// the value of a variable or a constant subexpression, for a uniform one whatever the item;
/// `finish(root, item)` takes the results; `note(choice, item, operand)` is called after a choice
/// that is not uniform was computed, with a function that gives its operands.
template <class Algebra, std::size_t lanes, class Leaf, class Finish, class Note = NoNotes>
void interpret_blocks(const Tape& tape, std::size_t size, Leaf leaf, Finish finish,
                      Note note = {}) {
    using Value = typename Algebra::Value;
    static_assert(std::is_trivially_destructible_v<Value>);
    Algebra algebra;
    Value* const values = scratch<Value>(tape.slots()).data();
    const std::span<const Tape::Step> steps = tape.steps();
    const auto compute = [&](const Tape::Step& step, std::size_t item) {
        const Node& node = tape.node(step);
        const Facts& facts = tape.facts(step);
        Value* const value = values + step.slot;
        const auto operand = [&](std::size_t k) {
            const Tape::Step& of = steps[step.operands[k]];
            return Operand<Value>{values[of.slot], tape.facts(of)};
        };
        // Made in its place, which no operand has: copying would cost as much as computing.
        if (is_leaf(node, facts)) {
            new (value) Value(leaf(node, facts, item));
            return;
        }
        const int operands = arity(node.op);
        new (value) Value(apply(algebra, node, operand(0), operand(operands < 2 ? 0 : 1),
                                operand(operands < 3 ? 0 : 2)));
        if (step.choice != Tape::no_choice) note(step, item, operand);
    };
    for (const Tape::Step& step : steps.first(tape.uniform_steps()))
        compute(step, 0);
    const auto varying = steps.subspan(tape.uniform_steps());
    for (std::size_t item = 0; item < size; item += lanes) {
        for (const Tape::Step& step : varying)
            compute(step, item);
        finish(values[tape.root().slot], item);
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
    interpret_blocks<IntervalAlgebra<Lanes>, Lanes::lanes>(*static_cast<const Tape*>(code),
                                                           batch->size, leaf, finish);
}

template <class Real, class Note>
void interpret_form_noting(const Tape& tape, const FormBatchOf<Real>* batch, Note note) {
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
    interpret_blocks<BeamAlgebra<Lanes>, Lanes::lanes>(tape, batch->size, leaf, finish, note);
}

template <class Real>
void interpret_form(const void* code, const FormBatchOf<Real>* batch) {
    interpret_form_noting(*static_cast<const Tape*>(code), batch, NoNotes());
}

/// The cells where the condition holds; all where it is absent.
unsigned bits_of(const std::optional<BlockMask>& mask) { return mask ? mask->bits : ~0U; }

/// Where one operand of min or max may stand for both, by their signs: one that is above 0 leaves
/// those of min to the other one, one below 0 those of max.
template <class Lanes>
ChoiceBits choice_by_sign(Op op, const BeamValue<Lanes>& a, const BeamValue<Lanes>& b) {
    const auto left_out = [op](const BeamValue<Lanes>& x) {
        const Interval<Lanes> range = x.f.range();
        const Lanes zero = like(range.hi, 0.0);
        const BlockMask apart = op == Op::Max ? range.hi < zero : range.neg_lo < zero;
        return static_cast<std::uint16_t>(apart.bits & bits_of(x.everywhere));
    };
    return {left_out(b), left_out(a)};
}

/// Where a choice is one of its alternatives, from its operands' forms: the other one must be
/// defined, too, and so must a condition.
template <class Lanes>
ChoiceBits choice_bits(Op op, const BeamValue<Lanes>& a, const BeamValue<Lanes>& b) {
    const auto made = [](unsigned first, unsigned second) {
        return ChoiceBits{static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(second)};
    };
    if (op == Op::If || op == Op::Where) {
        const BeamValue<Lanes>& condition = op == Op::If ? a : b;
        const unsigned defined = bits_of(condition.everywhere);
        const Interval<Lanes> range = condition.f.range();
        const unsigned holds = no(may_fail(range)).bits & defined;
        return made(holds, op == Op::If ? no(may_hold(range)).bits & defined : 0U);
    }
    const Kink<Lanes> kink = kink_of((a.f - b.f).range());
    const unsigned a_is_larger = kink.above.bits;
    const unsigned b_is_larger = kink.below.bits;
    return made((op == Op::Max ? a_is_larger : b_is_larger) & bits_of(b.everywhere),
                (op == Op::Max ? b_is_larger : a_is_larger) & bits_of(a.everywhere));
}

template <class Real>
void record_form(const Tape& tape, const FormBatchOf<Real>& batch, ChoiceRecord& record) {
    constexpr std::size_t lanes = Block<Real>::lanes;
    record.lanes = lanes;
    record.choices = tape.choices();
    record.bits.resize(batch.size / lanes * record.choices);
    interpret_form_noting(tape, &batch, [&](const Tape::Step& step, std::size_t item, auto of) {
        const Op op = tape.node(step).op;
        ChoiceBits bits = choice_bits(op, of(0).value, of(1).value);
        if (step.by_sign && (op == Op::Min || op == Op::Max)) {
            const ChoiceBits more = choice_by_sign(op, of(0).value, of(1).value);
            bits = {static_cast<std::uint16_t>(bits.first | more.first),
                    static_cast<std::uint16_t>(bits.second | more.second)};
        }
        record.bits[item / lanes * record.choices + step.choice] = bits;
    });
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
    interpret_blocks<DualAlgebra<Lanes>, Lanes::lanes>(*static_cast<const Tape*>(code), batch->size,
                                                       leaf, finish);
}

Kernel kernel_of(const std::shared_ptr<const Tape>& tape);

class TapeShortener final : public Shortener {
public:
    explicit TapeShortener(std::shared_ptr<const Tape> tape) : tape_(std::move(tape)) {}

    void form(const FormBatchOf<float>& batch, ChoiceRecord& record) const override {
        record_form(*tape_, batch, record);
    }
    void form(const FormBatchOf<double>& batch, ChoiceRecord& record) const override {
        record_form(*tape_, batch, record);
    }
    [[nodiscard]] std::optional<Kernel> shortened(
        const ChoiceRecord& record, std::span<const std::size_t> cells) const override {
        auto tape = tape_->shortened(record, cells);
        if (!tape) return std::nullopt;
        return kernel_of(std::make_shared<const Tape>(std::move(*tape)));
    }

private:
    std::shared_ptr<const Tape> tape_;
};

void set_code(Kernel& kernel, const std::shared_ptr<const Tape>& tape) {
    kernel.range_float = {interpret_range<float>, tape};
    kernel.value_float = {interpret_value<float>, tape};
    kernel.form_float = {interpret_form<float>, tape};
    kernel.ray_form_float = kernel.form_float;
    kernel.range_double = {interpret_range<double>, tape};
    kernel.value_double = {interpret_value<double>, tape};
    kernel.form_double = {interpret_form<double>, tape};
    kernel.ray_form_double = kernel.form_double;
    add_ray_functions(kernel);
    kernel.has_double = true;
    kernel.interpreted = true;
    if (tape->choices() > 0) kernel.shortener = std::make_shared<TapeShortener>(tape);
}

Kernel kernel_of(const std::shared_ptr<const Tape>& tape) {
    Kernel kernel;
    set_code(kernel, tape);
    return kernel;
}

}  // namespace

Kernel interpret(const Expr& expr) {
    Kernel kernel;
    kernel.parameters.assign(expr.parameters().begin(), expr.parameters().end());
    kernel.uses_w = expr.uses_variable(variable_w);
    set_code(kernel, std::make_shared<const Tape>(expr));
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
