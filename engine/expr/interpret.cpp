#include "engine/expr/interpret.hpp"

#include "engine/expr/algebra.hpp"
#include "engine/expr/block_choice.hpp"
#include "engine/expr/facts.hpp"
#include "engine/expr/float_check.hpp"
#include "engine/expr/frustum.hpp"
#include "engine/expr/least_of.hpp"
#include "engine/expr/part_values.hpp"
#include "engine/expr/ray_functions.hpp"
#include "engine/expr/tape.hpp"
#include "engine/expr/unowned.hpp"
#include "engine/num/block.hpp"

#include <algorithm>
#include <cstring>
#include <deque>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace zeroset {
namespace {

static_assert(batch_multiple % Block<float>::lanes == 0 &&
              batch_multiple % Block<double>::lanes == 0);

/// This thread's room for the values of a graph, kept from call to call. The code of a part may be
/// an interpreter, too, inside that of the whole: it has room of its own.
template <class Value>
class Scratch {
public:
    explicit Scratch(std::size_t slots) : values_(room(depth()++)) {
        if (values_.size() < slots) values_.resize(slots);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() { --depth(); }

    Value* data() { return values_.data(); }

private:
    static std::size_t& depth() {
        thread_local std::size_t calls = 0;
        return calls;
    }
    static std::vector<Value>& room(std::size_t call) {
        thread_local std::deque<std::vector<Value>> rooms;
        while (rooms.size() <= call)
            rooms.emplace_back();
        return rooms[call];
    }

    std::vector<Value>& values_;
};

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

/// What the algebra of a block asks and tells about switches, from and to the batch's arrays.
template <class Real>
class BlockBoard final : public SwitchBoard<Block<Real>> {
public:
    using Word = ContinuityMask<Real>;

    BlockBoard(const HeldSwitches<Real>& held, Word* branches) : held_(held), branches_(branches) {}

    /// The block that begins with this item.
    void begin(std::size_t item) {
        item_ = item;
        bits_.fill(0);
    }
    void end() const {
        if (branches_ != nullptr) std::ranges::copy(bits_, branches_ + item_);
    }
    std::optional<HeldAt<Block<Real>>> held(SwitchIndex index) override;
    void report(SwitchIndex index, const BlockMask& two, const BlockMask& three) override;
    void report_kink(const BlockMask& may_be) override {
        for (std::size_t lane = 0; lane < lanes; ++lane)
            bits_[lane] |= may_be.bits >> lane & BranchBits::kink;
    }

private:
    static constexpr std::size_t lanes = Block<Real>::lanes;

    HeldSwitches<Real> held_;
    Word* branches_;
    std::size_t item_ = 0;
    std::array<Word, lanes> bits_{};
};

template <class Real>
std::optional<HeldAt<Block<Real>>> BlockBoard<Real>::held(SwitchIndex index) {
    if (held_.words == nullptr) return std::nullopt;
    const Word* const words = held_.words + index / switches_a_word<Real> * held_.stride + item_;
    const std::size_t shift = held_bits * (index % switches_a_word<Real>);
    std::array<unsigned, 1U << held_bits> at{};
    for (std::size_t lane = 0; lane < lanes; ++lane)
        at[words[lane] >> shift & (at.size() - 1)] |= 1U << lane;
    const auto mask = [&](unsigned lanes_of_code) {
        return BlockMask{static_cast<std::uint16_t>(lanes_of_code)};
    };
    const auto number = [](double value) { return like(Block<Real>(), value); };
    const unsigned second = at[held_code(1, 2)] | at[held_code(1, 3)];
    const unsigned third = at[held_code(2, 3)];
    return HeldAt<Block<Real>>{
        mask(at[held_code(0, 2)] | at[held_code(1, 2)]),
        mask(at[held_code(0, 3)] | at[held_code(1, 3)] | third),
        select(mask(third), number(2), select(mask(second), number(1), number(0)))};
}

template <class Real>
void BlockBoard<Real>::report(SwitchIndex index, const BlockMask& two, const BlockMask& three) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const unsigned more = (two.bits >> lane & 1U) + 2 * (three.bits >> lane & 1U);
        const bool first = BranchBits{static_cast<std::uint32_t>(bits_[lane])}.outcomes() == 0;
        if (more == 0 || !first) continue;
        bits_[lane] |= static_cast<Word>(more) << BranchBits::more_outcomes_shift |
                       static_cast<Word>(index) << BranchBits::switch_shift;
    }
}

/// Takes the place of a board where an algebra knows no switches.
struct NoBoard {
    void begin(std::size_t /*item*/) {}
    void end() const {}
};

template <class Algebra, class Board>
Algebra algebra_with(Board& board) {
    if constexpr (std::is_constructible_v<Algebra, Board*>) {
        return Algebra(&board);
    } else {
        return Algebra();
    }
}

/// Makes choices as other operators are made.
struct NoChoices {
    template <class Algebra, class Values, class Value>
    bool operator()(Algebra& /*algebra*/, const Tape::Step& /*step*/, std::size_t /*item*/,
                    const Values& /*of*/, Value* /*place*/) const {
        return false;
    }
};

/// Evaluates the tape over `size` items by blocks of some lanes. `leaf(node, facts, item)` makes
/// the value of a variable or a constant subexpression, for a uniform one whatever the item;
/// `part(shape, part, item)` that of a part; `finish(root, item)` takes the results.
/// `board` is told of switches. `choose(algebra, step, item, operand, place)`, with a function that
/// gives operands, is asked for choices that are not uniform; it answers whether it made them in
/// their place.
template <class Algebra, std::size_t lanes, class Board, class Leaf, class OfPart, class Finish,
          class Choose = NoChoices>
void interpret_blocks(const Tape& tape, std::size_t size, Board&& board, Leaf leaf, OfPart part,
                      Finish finish, Choose choose = {}) {
    using Value = typename Algebra::Value;
    static_assert(std::is_trivially_destructible_v<Value>);
    auto algebra = algebra_with<Algebra>(board);
    Scratch<Value> scratch(tape.slots());
    Value* const values = scratch.data();
    const std::span<const Tape::Step> steps = tape.steps();
    const Parts& parts = tape.graph()->parts;
    const auto compute = [&](const Tape::Step& step, std::size_t item) {
        const Node& node = tape.node(step);
        const Facts& facts = tape.facts(step);
        Value* const value = values + step.slot;
        const auto operand = [&](std::size_t k) {
            const Tape::Step& of = steps[step.operands[k]];
            return Operand<Value>{values[of.slot], tape.facts(of)};
        };
        // Made in its place, which no operand has: copying would cost as much as computing.
        if (const std::uint32_t index = tape.part(step); index != Parts::none) {
            const Part& of = parts.parts[index];
            new (value) Value(part(parts.shapes[of.shape], of, item));
            return;
        }
        if (is_leaf(node, facts)) {
            new (value) Value(leaf(node, facts, item));
            return;
        }
        if (step.choice != Tape::no_choice && choose(algebra, step, item, operand, value)) return;
        enter_switch(algebra, step.own_switch);
        const int operands = arity(node.op);
        new (value) Value(apply(algebra, node, operand(0), operand(operands < 2 ? 0 : 1),
                                operand(operands < 3 ? 0 : 2)));
    };
    for (const Tape::Step& step : steps.first(tape.uniform_steps()))
        compute(step, 0);
    const auto varying = steps.subspan(tape.uniform_steps());
    for (std::size_t item = 0; item < size; item += lanes) {
        board.begin(item);
        for (const Tape::Step& step : varying)
            compute(step, item);
        board.end();
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
    const auto of_part = [&](const PartShape& shape, const Part& part, std::size_t i) {
        return part_range(shape, part, *batch, i);
    };
    const auto finish = [&](const Enclosure<Lanes>& f, std::size_t i) {
        const Interval<Lanes> range = answer(f);
        store(batch->f_neg_lo + i, range.neg_lo);
        store(batch->f_hi + i, range.hi);
        store<Real>(batch->continuous + i, conjunction(f.everywhere, f.continuous), true);
    };
    interpret_blocks<IntervalAlgebra<Lanes>, Lanes::lanes>(
        *static_cast<const Tape*>(code), batch->size,
        BlockBoard<Real>(batch->held, batch->branches), leaf, of_part, finish);
}

/// `record`: of how choices fall; then the form may be that of a function with the same signs and
/// zeros.
template <class Real>
void interpret_cells(const Tape& tape, const FormBatchOf<Real>* batch, bool on_rays,
                     ChoiceRecord* record) {
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
    BlockBoard<Real> board(batch->held, batch->branches);
    const auto of_part = [&](const PartShape& shape, const Part& part, std::size_t i) {
        BeamValue<Lanes> value;
        board.report_kink(part_form(shape, part, *batch, i, on_rays, value));
        return value;
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
    const auto choose = [&](BeamAlgebra<Lanes>& algebra, const Tape::Step& step, std::size_t i,
                            const auto& of, BeamValue<Lanes>* place) {
        const Op op = tape.node(step).op;
        const bool extreme = op == Op::Min || op == Op::Max;
        const auto tell = [&](Tape::Index choice, const ChoiceBits& bits) {
            record->bits[i / Lanes::lanes * record->choices + choice] = bits;
        };
        if (!extreme) {
            if (record == nullptr) return false;
            if (op == Op::And || op == Op::Or) {
                tell(step.choice, choice_by_logic(op, of(0).value, of(1).value));
            } else {
                tell(step.choice, choice_by_condition(op, of(op == Op::If ? 0 : 1).value));
            }
            return false;
        }
        ChoiceBits left_out{};
        if (record != nullptr) left_out = choice_by_band(op, of(0).value, of(1).value, step.band);
        const ChoiceBits bits = make_extreme<Real>(algebra, op, of(0), of(1), left_out, place);
        if (step.height > 0) narrow_to(step.height, *place);
        if (record == nullptr) return true;
        tell(step.choice, bits);
        if (step.tells != Tape::no_choice) tell(step.tells, left_out);
        return true;
    };
    interpret_blocks<BeamAlgebra<Lanes>, Lanes::lanes>(tape, batch->size, board, leaf, of_part,
                                                       finish, choose);
}

template <class Real>
void interpret_form(const void* code, const FormBatchOf<Real>* batch) {
    interpret_cells(*static_cast<const Tape*>(code), batch, false, nullptr);
}

template <class Real>
void interpret_ray_form(const void* code, const FormBatchOf<Real>* batch) {
    interpret_cells(*static_cast<const Tape*>(code), batch, true, nullptr);
}

template <class Real>
void record_form(const Tape& tape, const FormBatchOf<Real>& batch, ChoiceRecord& record) {
    record.lanes = Block<Real>::lanes;
    record.choices = tape.choices();
    record.bits.resize(batch.size / record.lanes * record.choices);
    interpret_cells(tape, &batch, false, &record);
}

/// Without gradients the variables have no slopes, and so nothing has.
template <class Real, bool with_gradient>
void interpret_value(const void* code, const ValueBatchOf<Real>* batch) {
    using Lanes = Block<Real>;
    const auto leaf = [&](const Node& node, const Facts& facts, std::size_t i) -> Dual<Lanes> {
        if (facts.constant) return {Lanes::splat(facts.constant_point<Real>()), {}};
        const auto v = static_cast<std::size_t>(node.number);
        if (v >= 3) return {Lanes::splat(batch->uniforms[v - 3]), {}};
        Dual<Lanes> variable{load(batch->x[v] + i), {}};
        if constexpr (with_gradient) variable.slope[v] = Lanes::splat(1);
        return variable;
    };
    const auto of_part = [&](const PartShape& shape, const Part& part, std::size_t i) {
        return part_value(shape, part, *batch, i);
    };
    const auto finish = [&](const Dual<Lanes>& f, std::size_t i) {
        store(batch->f + i, f.value);
        if constexpr (!with_gradient) return;
        for (std::size_t k = 0; k < 3; ++k)
            store(batch->gradient[k] + i, f.slope[k].value_or(Lanes::splat(0)));
    };
    interpret_blocks<DualAlgebra<Lanes>, Lanes::lanes>(*static_cast<const Tape*>(code), batch->size,
                                                       NoBoard(), leaf, of_part, finish);
}

class TapeShortener : public Shortener {
public:
    explicit TapeShortener(std::shared_ptr<const Tape> tape) : tape_(std::move(tape)) {}

    void form(const FormBatchOf<float>& batch, ChoiceRecord& record) const override {
        record_form(*tape_, batch, record);
    }
    void form(const FormBatchOf<double>& batch, ChoiceRecord& record) const override {
        record_form(*tape_, batch, record);
    }
    [[nodiscard]] std::shared_ptr<const Kernel> shortened(
        const ChoiceRecord& record, std::span<const std::size_t> cells) const override;

private:
    std::shared_ptr<const Tape> tape_;
};

/// All but the functions over rays.
void set_code(Kernel& kernel, const std::shared_ptr<const Tape>& tape) {
    kernel.range_float = {interpret_range<float>, tape};
    kernel.value_float = {interpret_value<float, true>, tape};
    kernel.form_float = {interpret_form<float>, tape};
    kernel.ray_form_float = {interpret_ray_form<float>, tape};
    kernel.range_double = {interpret_range<double>, tape};
    kernel.value_double = {interpret_value<double, true>, tape};
    kernel.form_double = {interpret_form<double>, tape};
    kernel.ray_form_double = {interpret_ray_form<double>, tape};
    kernel.has_double = true;
    kernel.interpreted = true;
    kernel.switches = tape->graph()->switch_count;
    kernel.branches = true;
}

/// A tape and its kernel in one piece: thousands are made for a frame.
struct TapeKernel {
    explicit TapeKernel(Tape code) : tape(std::move(code)), shortener(unowned(tape)) {
        set_code(kernel, unowned(tape));
        add_ray_functions_in_place(kernel);
        if (tape.choices() > 0) kernel.shortener = unowned<Shortener>(shortener);
    }
    TapeKernel(const TapeKernel&) = delete;
    TapeKernel& operator=(const TapeKernel&) = delete;
    ~TapeKernel() = default;

    Tape tape;
    TapeShortener shortener;
    Kernel kernel;
};

std::shared_ptr<const Kernel> TapeShortener::shortened(const ChoiceRecord& record,
                                                       std::span<const std::size_t> cells) const {
    auto tape = tape_->shortened(record, cells);
    if (!tape) return nullptr;
    const auto& graph = tape->graph();
    if (const auto part = tape->part(tape->root()); part != Parts::none)
        return {graph, &graph->part_kernels[part]};
    const auto made = std::make_shared<const TapeKernel>(std::move(*tape));
    return {made, &made->kernel};
}

/// Nothing where there are not several.
std::optional<LeastOf> operands_of_least(const std::shared_ptr<const TapeGraph>& graph) {
    const std::vector<NodeId> nodes = graph->least_of();
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
    return std::optional<LeastOf>(std::in_place, std::move(kernels), std::move(owners));
}

/// Of a whole formula.
class WholeShortener final : public TapeShortener {
public:
    explicit WholeShortener(const std::shared_ptr<const Tape>& tape)
        : TapeShortener(tape), least_of_(operands_of_least(tape->graph())) {}

    [[nodiscard]] const LeastOf* least_of() const override {
        return least_of_ ? &*least_of_ : nullptr;
    }

private:
    std::optional<LeastOf> least_of_;
};

}  // namespace

Kernel interpret(const Expr& expr) { return interpret(expr, facts_of(expr), {}); }

Kernel interpret(const Expr& expr, std::vector<Facts> facts, Parts parts) {
    Kernel kernel;
    kernel.parameters.assign(expr.parameters().begin(), expr.parameters().end());
    kernel.uses_w = expr.uses_variable(variable_w);
    const auto tape = std::make_shared<const Tape>(
        std::make_shared<const TapeGraph>(expr, std::move(facts), std::move(parts)));
    set_code(kernel, tape);
    add_ray_functions(kernel);
    kernel.float_check = std::make_shared<const FloatCheck>(expr, kernel);
    if (tape->choices() > 0) kernel.shortener = std::make_shared<WholeShortener>(tape);
    return kernel;
}

PointFunction interpret_points(const Expr& expr) {
    return {interpret_value<double, false>,
            std::make_shared<const Tape>(
                std::make_shared<const TapeGraph>(expr, facts_of(expr), Parts{}))};
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
