#include "engine/tape/tape.hpp"

#include "engine/tape/tape_marks.hpp"
#include "engine/tape/tape_reduction.hpp"

#include <numeric>
#include <utility>

namespace zeroset {
namespace {

using Index = Tape::Index;
using Step = Tape::Step;

constexpr Index never = 0;           ///< no step needs it: the first step has no operands
constexpr Index always = ~Index{0};  ///< needed to the end

std::array<NodeId, 3> operands_of(const Node& node) { return {node.a, node.b, node.c}; }

/// The nodes that `root` needs: each behind its operands, and those soon behind theirs, so that few
/// values wait for their use at a time.
std::vector<NodeId> in_order(const TapeGraph& graph, NodeId root) {
    std::vector<bool> seen(graph.expr.nodes().size(), false);
    struct Visit {
        NodeId id;
        std::size_t next;  ///< operand
    };
    std::vector<Visit> stack{{.id = root, .next = 0}};
    std::vector<NodeId> order;
    seen[root] = true;
    while (!stack.empty()) {
        Visit& visit = stack.back();
        if (visit.next == graph.operand_counts[visit.id]) {
            order.push_back(visit.id);
            stack.pop_back();
            continue;
        }
        const NodeId operand = operands_of(graph.expr.node(visit.id))[visit.next++];
        if (!seen[operand]) stack.push_back({.id = operand, .next = 0});
        seen[operand] = true;
    }
    return order;
}

/// Lists kept from call to call: for small tapes allocations cost most.
struct TapeLists {
    std::vector<Index> last_use, place, place_of_node, unused;
};
TapeLists& tape_lists() {
    thread_local TapeLists instance;
    return instance;
}

}  // namespace

/// Makes a tape of those steps of another that are needed.
class Tape::Builder {
public:
    /// `stands_for`: for each step, the one whose value is taken instead; `switches`: its place
    /// among the graph's, with those whose place it takes.
    Builder(std::span<const Step> steps, std::size_t uniform, std::span<const Index> stands_for,
            std::span<const SwitchIndex> switches)
        : steps_(steps),
          uniform_(uniform),
          stands_for_(stands_for),
          switches_(switches),
          last_use_(tape_lists().last_use),
          place_(tape_lists().place),
          unused_(tape_lists().unused) {
        last_use_.assign(steps.size(), never);
        place_.resize(steps.size());
        unused_.clear();
    }

    Tape build(std::shared_ptr<const TapeGraph> graph, Index root);

private:
    void find_last_uses(const TapeGraph& graph, Index root);
    void append(Tape& tape, Index index);
    /// The slot of a value that step `index` is the last to need is free behind it.
    void release(const Tape& tape, Index operand, Index index);

    std::span<const Step> steps_;
    std::size_t uniform_;
    std::span<const Index> stands_for_;
    std::span<const SwitchIndex> switches_;
    std::vector<Index>& last_use_;
    std::vector<Index>& place_;   ///< in the new tape
    std::vector<Index>& unused_;  ///< slots
};

void Tape::Builder::find_last_uses(const TapeGraph& graph, Index root) {
    last_use_[root] = always;
    for (Index i = root; i > 0; --i) {
        if (last_use_[i] == never) continue;
        const std::size_t count = graph.operand_counts[steps_[i].node];
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
    Step step{.node = steps_[index].node, .slot = tape.slots_, .operands = {}};
    if (uniform || unused_.empty()) {
        ++tape.slots_;
    } else {
        step.slot = unused_.back();
        unused_.pop_back();
    }
    const std::size_t operands = tape.graph_->operand_counts[step.node];
    tape.sums_ = tape.sums_ || (operands > 0 && is_sum(tape.node(step).op));
    for (std::size_t k = 0; k < operands; ++k) {
        const Index operand = stands_for_[steps_[index].operands[k]];
        step.operands[k] = place_[operand];
        if (!uniform) release(tape, operand, index);
    }
    step.own_switch = switches_[index];
    if (!uniform && may_be_operand(tape.node(step).op)) {
        step.choice = static_cast<Index>(tape.choices_++);
    }
    place_[index] = static_cast<Index>(tape.steps_.size());
    tape.steps_.push_back(step);
    if (uniform) {
        tape.uniform_ = tape.steps_.size();
    } else if (operands > 0 && is_sum(tape.node(step).op)) {
        tape.mark_blend(place_[index]);
    }
}

Tape Tape::Builder::build(std::shared_ptr<const TapeGraph> graph, Index root) {
    find_last_uses(*graph, root);
    Tape tape;
    tape.graph_ = std::move(graph);
    for (Index i = 0; i <= root; ++i) {
        if (last_use_[i] != never) append(tape, i);
    }
    mark_bands(*tape.graph_, tape.steps_);
    return tape;
}

void Tape::mark_blend(Index sum) {
    if (choices_ < 2) return;
    const std::optional<Blend> blend = blend_of(*this, steps_[sum]);
    if (!blend) return;
    Step& extreme = steps_[blend->extreme];
    Step& hat = steps_[blend->hat];
    for (const Step* step : {&extreme, &hat}) {
        if (step->tells != no_choice || step->heeds != no_choice) return;
    }
    extreme.tells = hat.heeds = static_cast<Index>(choices_++);
    steps_[sum].reach = blend->reach;
    hat.height = blend->height;
}

Tape::Tape(const std::shared_ptr<const TapeGraph>& graph) : Tape(graph, graph->expr.root()) {}

Tape::Tape(std::shared_ptr<const TapeGraph> graph, NodeId root) {
    const std::vector<NodeId> order = in_order(*graph, root);
    std::vector<Index>& place = tape_lists().place_of_node;
    place.resize(graph->expr.nodes().size());
    std::vector<Step> steps;
    steps.reserve(order.size());
    std::size_t uniform = 0;
    for (const bool want_uniform : {true, false}) {
        for (const NodeId id : order) {
            if (graph->facts[id].uniform != want_uniform) continue;
            place[id] = static_cast<Index>(steps.size());
            Step& step = steps.emplace_back(Step{.node = id, .slot = 0, .operands = {}});
            for (std::size_t k = 0; k < graph->operand_counts[id]; ++k)
                step.operands[k] = place[operands_of(graph->expr.node(id))[k]];
        }
        if (want_uniform) uniform = steps.size();
    }
    std::vector<Index> itself(steps.size());
    std::iota(itself.begin(), itself.end(), Index{0});
    std::vector<SwitchIndex> switches;
    switches.reserve(steps.size());
    for (const Step& step : steps)
        switches.push_back(graph->switches[step.node]);
    *this = Builder(steps, uniform, itself, switches).build(std::move(graph), place[root]);
}

std::optional<Tape> Tape::specialized(const ChoiceRecord& record,
                                      std::span<const std::size_t> cells) const {
    const TapeReduction reduction(*this, record, cells);
    if (!reduction.any()) return std::nullopt;
    const std::span<const Index> stands_for = reduction.stands_for();
    return Builder(steps_, uniform_, stands_for, reduction.switches())
        .build(graph_, stands_for[steps_.size() - 1]);
}

}  // namespace zeroset
