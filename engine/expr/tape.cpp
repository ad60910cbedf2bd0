#include "engine/expr/tape.hpp"

#include "engine/expr/algebra.hpp"

#include <numeric>

namespace zeroset {
namespace {

using Index = Tape::Index;
using Step = Tape::Step;

constexpr Index never = 0;           ///< no step needs it: the first step has no operands
constexpr Index always = ~Index{0};  ///< needed to the end

bool is_choice(Op op) { return op == Op::Min || op == Op::Max || op == Op::If || op == Op::Where; }

/// The step's operand that its value is, where the choice falls so; 0 is the first.
Index alternative(Op op, const Step& step, std::size_t which) {
    return step.operands[op == Op::If ? which + 1 : which];
}

/// Whether all that operand k does to the operator's sign comes from its own.
bool hands_on_sign(Op op, std::size_t k) {
    if (op == Op::Where) return k == 0;
    if (op == Op::If) return k > 0;
    return op == Op::Min || op == Op::Max || op == Op::Negate;
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

std::size_t operand_count(const TapeGraph& graph, NodeId id) {
    const Node& node = graph.expr.node(id);
    return is_leaf(node, graph.facts[id]) ? 0 : static_cast<std::size_t>(arity(node.op));
}

}  // namespace

/// Makes a tape of those steps of another that are needed.
class Tape::Builder {
public:
    /// `stands_for`: for each step, the one whose value is taken instead.
    Builder(std::span<const Step> steps, std::size_t uniform, std::span<const Index> stands_for)
        : steps_(steps), uniform_(uniform), stands_for_(stands_for) {}

    Tape build(std::shared_ptr<const TapeGraph> graph, Index root);

private:
    void find_last_uses(const TapeGraph& graph, Index root);
    void append(Tape& tape, Index index);
    /// The slot of a value that step `index` is the last to need is free behind it.
    void release(const Tape& tape, Index operand, Index index);

    std::span<const Step> steps_;
    std::size_t uniform_;
    std::span<const Index> stands_for_;
    std::vector<Index> last_use_ = std::vector<Index>(steps_.size(), never);
    std::vector<Index> place_ = std::vector<Index>(steps_.size());  ///< in the new tape
    std::vector<Index> unused_;                                     ///< slots
};

void Tape::Builder::find_last_uses(const TapeGraph& graph, Index root) {
    last_use_[root] = always;
    for (Index i = root; i > 0; --i) {
        if (last_use_[i] == never) continue;
        const std::size_t count = operand_count(graph, steps_[i].node);
        for (std::size_t k = 0; k < count; ++k) {
            Index& last = last_use_[stands_for_[steps_[i].operands[k]]];
            if (last == never) last = i;
        }
    }
}

void Tape::Builder::release(const Tape& tape, Index operand, Index index) {
    if (operand < uniform_ || last_use_[operand] != index) return;
    unused_.push_back(tape.steps_[place_[operand]].slot);
    last_use_[operand] = always;  // also where it is the next operand
}

void Tape::Builder::append(Tape& tape, Index index) {
    const bool uniform = index < uniform_;
    Step step{steps_[index].node, tape.slots_, {}, no_choice};
    if (uniform || unused_.empty()) {
        ++tape.slots_;
    } else {
        step.slot = unused_.back();
        unused_.pop_back();
    }
    const std::size_t operands = operand_count(*tape.graph_, step.node);
    for (std::size_t k = 0; k < operands; ++k) {
        const Index operand = stands_for_[steps_[index].operands[k]];
        step.operands[k] = place_[operand];
        if (!uniform) release(tape, operand, index);
    }
    if (!uniform && is_choice(tape.node(step).op)) {
        step.choice = static_cast<Index>(tape.choices_++);
    }
    place_[index] = static_cast<Index>(tape.steps_.size());
    tape.steps_.push_back(step);
    if (uniform) tape.uniform_ = tape.steps_.size();
}

Tape Tape::Builder::build(std::shared_ptr<const TapeGraph> graph, Index root) {
    find_last_uses(*graph, root);
    Tape tape;
    tape.graph_ = std::move(graph);
    for (Index i = 0; i <= root; ++i) {
        if (last_use_[i] != never) append(tape, i);
    }
    tape.mark_by_sign();
    return tape;
}

/// From the root down through operators that make signs of signs.
void Tape::mark_by_sign() {
    std::vector<std::uint8_t> by_value(steps_.size(), 0);
    steps_.back().by_sign = true;
    for (std::size_t i = steps_.size(); i-- > 0;) {
        Step& step = steps_[i];
        step.by_sign = step.by_sign && by_value[i] == 0;
        const std::size_t count = operand_count(*graph_, step.node);
        for (std::size_t k = 0; k < count; ++k) {
            if (step.by_sign && hands_on_sign(node(step).op, k)) {
                steps_[step.operands[k]].by_sign = true;
            } else {
                by_value[step.operands[k]] = 1;
            }
        }
    }
}

Tape::Tape(const Expr& expr) {
    const auto graph = std::make_shared<TapeGraph>(TapeGraph{expr, facts_of(expr)});
    const std::size_t count = expr.nodes().size();
    std::vector<Index> place(count);
    std::vector<Step> steps;
    steps.reserve(count);
    std::size_t uniform = 0;
    for (const bool want_uniform : {true, false}) {
        for (NodeId id = 0; id < count; ++id) {
            if (graph->facts[id].uniform != want_uniform) continue;
            const Node& node = expr.node(id);
            place[id] = static_cast<Index>(steps.size());
            steps.push_back({id, 0, {place[node.a], place[node.b], place[node.c]}});
        }
        if (want_uniform) uniform = steps.size();
    }
    std::vector<Index> itself(count);
    std::iota(itself.begin(), itself.end(), Index{0});
    *this = Builder(steps, uniform, itself).build(graph, place[expr.root()]);
}

std::optional<Tape> Tape::shortened(const ChoiceRecord& record,
                                    std::span<const std::size_t> cells) const {
    std::vector<Index> stands_for(steps_.size());
    bool shorter = false;
    for (Index i = 0; i < steps_.size(); ++i) {
        const Step& step = steps_[i];
        stands_for[i] = i;
        if (step.choice == no_choice) continue;
        const std::optional<std::size_t> which = winner(record, step.choice, cells);
        if (!which) continue;
        const Index taken = stands_for[alternative(node(step).op, step, *which)];
        // What is built on it may rely on that.
        if (facts(step).nonnegative && !facts(steps_[taken]).nonnegative) continue;
        stands_for[i] = taken;
        shorter = true;
    }
    if (!shorter) return std::nullopt;
    return Builder(steps_, uniform_, stands_for).build(graph_, stands_for[steps_.size() - 1]);
}

}  // namespace zeroset
