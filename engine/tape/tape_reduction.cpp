#include "engine/tape/tape_reduction.hpp"

#include "engine/algebra/switches.hpp"

namespace zeroset {
namespace {

using Index = Tape::Index;
using Step = Tape::Step;

/// The step's operand that its value is, where the choice falls so; 0 is the first.
Index alternative(Op op, const Step& step, std::size_t which) {
    return step.operands[op == Op::If ? which + 1 : which];
}

/// Which alternative a choice is in all of the cells, if it is one.
std::optional<std::size_t> winner(const ChoiceRecord& record, Index choice,
                                  std::span<const std::size_t> cells) {
    bool first = true;
    bool second = true;
    for (const std::size_t cell : cells) {
        const ChoiceBits& bits = record.bits[cell / record.lanes * record.choices + choice];
        first = first && (bits.first >> cell % record.lanes & 1U) != 0;
        second = second && (bits.second >> cell % record.lanes & 1U) != 0;
        if (!first && !second) return std::nullopt;
    }
    return first ? 0 : 1;
}

/// Lists kept from call to call: for small tapes allocations cost most.
struct ReductionLists {
    std::vector<Index> stands_for;
    std::vector<SwitchIndex> switches;
    std::vector<std::uint8_t> zero;
};
ReductionLists& reduction_lists() {
    thread_local ReductionLists instance;
    return instance;
}

}  // namespace

TapeReduction::TapeReduction(const Tape& tape, const ChoiceRecord& record,
                             std::span<const std::size_t> cells)
    : tape_(tape),
      stands_for_(reduction_lists().stands_for),
      switches_(reduction_lists().switches),
      zero_(reduction_lists().zero) {
    const std::size_t size = tape.steps().size();
    stands_for_.resize(size);
    switches_.resize(size);
    zero_.resize(size);
    for (Index i = 0; i < size; ++i)
        reduce(i, record, cells);
}

void TapeReduction::reduce(Index i, const ChoiceRecord& record,
                           std::span<const std::size_t> cells) {
    const Step& step = tape_.steps()[i];
    stands_for_[i] = i;
    switches_[i] = step.own_switch;
    zero_[i] = tape_.has_sums() && is_zero(step) ? 1 : 0;
    if (zero_[i] != 0 && i < tape_.uniform_steps()) number_zero_ = i;
    std::optional<Index> taken;
    if (zero_[i] != 0 && any_) taken = number_zero_;
    if (!taken) taken = same_as(step, record, cells);
    if (!taken || *taken == i) return;
    // Steps built on this one may rely on that.
    if (tape_.facts(step).nonnegative && !tape_.facts(tape_.steps()[*taken]).nonnegative) return;
    stands_for_[i] = *taken;
    // Where the conditions are the same, so are the outcomes.
    const bool varies = *taken >= tape_.uniform_steps();
    if (varies && is_condition(tape_.node(step).op) && switches_[*taken] == no_switch)
        switches_[*taken] = step.own_switch;
    zero_[i] = zero_[*taken];
    any_ = true;
}

std::optional<TapeReduction::Index> TapeReduction::same_as(
    const Step& step, const ChoiceRecord& record, std::span<const std::size_t> cells) const {
    if (step.choice == Tape::no_choice) return summand(step);
    const std::optional<std::size_t> which = winner(record, step.choice, cells);
    if (!which && step.heeds != Tape::no_choice && winner(record, step.heeds, cells)) {
        const Index a = step.operands[0];
        return zero_[a] != 0 ? a : step.operands[1];
    }
    if (!which) return std::nullopt;
    return stands_for_[alternative(tape_.node(step).op, step, *which)];
}

std::optional<TapeReduction::Index> TapeReduction::summand(const Step& step) const {
    if (!any_ || !tape_.has_sums()) return std::nullopt;
    const Op op = tape_.node(step).op;
    if (!is_sum(op) || tape_.graph()->is_first(step.node)) return std::nullopt;
    const Index a = stands_for_[step.operands[0]];
    const Index b = stands_for_[step.operands[1]];
    if (zero_[b] != 0) return a;
    return op == Op::Add && zero_[a] != 0 ? std::optional(b) : std::nullopt;
}

bool TapeReduction::is_zero(const Step& step) const {
    const Facts& facts = tape_.facts(step);
    if (facts.exact()) return facts.constant->hi == 0;
    if (tape_.graph()->is_first(step.node)) return false;
    const Node& node = tape_.node(step);
    const auto operand_is_zero = [&](std::size_t k) {
        return zero_[stands_for_[step.operands[k]]] != 0;
    };
    const auto nonzero_constant = [&](std::size_t k) {
        const auto& box = tape_.facts(tape_.steps()[step.operands[k]]).constant;
        return box && (box->neg_lo < 0 || box->hi < 0);
    };
    if (node.op == Op::Divide) return operand_is_zero(0) && nonzero_constant(1);
    if (node.op == Op::Multiply) {
        return (operand_is_zero(0) && nonzero_constant(1)) ||
               (operand_is_zero(1) && nonzero_constant(0));
    }
    const bool keeps_zero = node.op == Op::Negate || node.op == Op::Abs || node.op == Op::Sqrt ||
                            (node.op == Op::IntPower && node.number > 0);
    return keeps_zero && operand_is_zero(0);
}

}  // namespace zeroset
