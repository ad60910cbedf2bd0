#include "engine/interpret/tape.hpp"

#include "engine/algebra/algebra.hpp"
#include "engine/interpret/part_kernel.hpp"
#include "engine/interpret/tape_blend.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace zeroset {
namespace {

using Index = Tape::Index;
using Step = Tape::Step;

constexpr Index never = 0;           ///< no step needs it: the first step has no operands
constexpr Index always = ~Index{0};  ///< needed to the end

bool is_sum(Op op) { return op == Op::Add || op == Op::Subtract; }

/// The step's operand that its value is, where the choice falls so; 0 is the first.
Index alternative(Op op, const Step& step, std::size_t which) {
    return step.operands[op == Op::If ? which + 1 : which];
}

Band negative(const Band& band) { return {-band.hi, -band.lo}; }
Band hull(const Band& a, const Band& b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }
/// The band of x, from that of c x with c > 0 in the interval.
Band divided(const Band& band, const Interval<double>& c) {
    const double least = -c.neg_lo;
    const double most = c.hi;
    const auto far = [](double end, double by) { return end / by + 0x1p-50 * std::abs(end / by); };
    return {-far(-band.lo, band.lo < 0 ? least : most), far(band.hi, band.hi > 0 ? least : most)};
}
/// The band of x, from that of x + c with c in the interval.
Band moved_back(const Band& band, const Interval<double>& c) {
    const double lo = band.lo - c.hi;
    const double hi = band.hi + c.neg_lo;
    return {lo - 0x1p-50 * std::abs(lo), hi + 0x1p-50 * std::abs(hi)};
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
    return graph.is_first(id) ? 0 : static_cast<std::size_t>(arity(graph.expr.node(id).op));
}

std::array<NodeId, 3> operands_of(const Node& node) { return {node.a, node.b, node.c}; }

/// The nodes that `root` needs: each behind its operands, and those soon behind theirs, so that few
/// values wait for their use at a time.
std::vector<NodeId> in_order(const TapeGraph& graph, NodeId root) {
    std::vector<bool> seen(graph.expr.nodes().size(), false);
    struct Visit {
        NodeId id;
        std::size_t next;  ///< operand
    };
    std::vector<Visit> stack{{root, 0}};
    std::vector<NodeId> order;
    seen[root] = true;
    while (!stack.empty()) {
        Visit& visit = stack.back();
        if (visit.next == operand_count(graph, visit.id)) {
            order.push_back(visit.id);
            stack.pop_back();
            continue;
        }
        const NodeId operand = operands_of(graph.expr.node(visit.id))[visit.next++];
        if (!seen[operand]) stack.push_back({operand, 0});
        seen[operand] = true;
    }
    return order;
}

/// What specializing a tape takes, kept from call to call: for small tapes allocations cost most.
struct Room {
    std::vector<Index> stands_for, last_use, place, place_of_node, unused;
    std::vector<SwitchIndex> switches;
    std::vector<std::uint8_t> zero;
};
Room& room() {
    thread_local Room instance;
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
          last_use_(room().last_use),
          place_(room().place),
          unused_(room().unused) {
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
    Step step{.node = steps_[index].node, .slot = tape.slots_, .operands = {}};
    if (uniform || unused_.empty()) {
        ++tape.slots_;
    } else {
        step.slot = unused_.back();
        unused_.pop_back();
    }
    const std::size_t operands = operand_count(*tape.graph_, step.node);
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
    tape.mark_bands();
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

/// From the root down.
void Tape::mark_bands() {
    for (Step& step : steps_)
        step.band = Band::nothing();
    steps_.back().band = {0, 0};
    for (std::size_t i = steps_.size(); i-- > 0;) {
        Step& step = steps_[i];
        if (step.band.empty()) continue;  // the q of a smooth minimum
        const std::size_t count = operand_count(*graph_, step.node);
        for (std::size_t k = 0; k < count; ++k) {
            Band& band = steps_[step.operands[k]].band;
            band = hull(band, band_of(step, k));
        }
    }
    for (Step& step : steps_) {
        if (!step.band.empty()) {
            step.heeds = no_choice;  // it is asked for elsewhere
        } else {
            step.band = Band::everything();
        }
    }
}

Band Tape::band_of(const Step& step, std::size_t k) const {
    const Op op = node(step).op;
    if (is_choice(op)) return is_alternative(op, k) ? step.band : Band::everything();
    if (op == Op::Negate) return negative(step.band);
    if (op == Op::SmoothMin) return band_of_alternative(op, step.band);
    if (op == Op::Multiply) return band_of_factor(step, k);
    if (!is_sum(op)) return Band::everything();
    const Band band = op == Op::Subtract && k == 1 ? negative(step.band) : step.band;
    const Step& operand = steps_[step.operands[k]];
    const Step& other = steps_[step.operands[1 - k]];
    if (step.reach > 0) {
        if (operand.tells == no_choice) return Band::nothing();
        return node(operand).op == Op::Min ? Band{band.lo, band.hi + step.reach}
                                           : Band{band.lo - step.reach, band.hi};
    }
    if (!facts(other).constant) return Band::everything();
    const Interval<double>& c = *facts(other).constant;
    const bool minus = op == Op::Subtract;
    return moved_back(band, minus ? -c : c);
}

Band Tape::band_of_factor(const Step& step, std::size_t k) const {
    const auto& c = facts(steps_[step.operands[1 - k]]).constant;
    if (!c || (c->neg_lo >= 0 && c->hi >= 0)) return Band::everything();
    return c->neg_lo < 0 ? divided(step.band, *c) : negative(divided(step.band, -*c));
}

TapeGraph::TapeGraph(const Expr& graph, std::vector<Facts> known, Parts with_code)
    : expr(graph), facts(std::move(known)), parts(std::move(with_code)) {
    parts.of_node.resize(expr.nodes().size(), Parts::none);
    // The code of parts does not know their constants.
    const std::vector<Facts> whole = std::exchange(facts, {});
    for (NodeId id = 0; id < whole.size(); ++id) {
        const std::uint32_t part = parts.of_node[id];
        if (part != Parts::none) {
            facts.push_back(parts.shapes[parts.parts[part].shape].facts);
        } else {
            facts.push_back(parts.parts.empty() ? whole[id] : facts_of_node(expr.node(id), facts));
        }
    }
    switches = switches_of(expr, facts);
    switch_count = count_switches(switches);
    for (std::uint32_t part = 0; part < parts.parts.size(); ++part)
        part_kernels.push_back(kernel_of_part(parts, part));
}

bool TapeGraph::is_first(NodeId id) const {
    return parts.of_node[id] != Parts::none || is_leaf(expr.node(id), facts[id]);
}

std::vector<NodeId> TapeGraph::union_parts() const {
    std::vector<bool> seen(expr.nodes().size(), false);
    std::vector<NodeId> stack{expr.root()};
    std::vector<NodeId> least;
    while (!stack.empty()) {
        const NodeId id = stack.back();
        stack.pop_back();
        if (seen[id]) continue;
        seen[id] = true;
        const Node& node = expr.node(id);
        if (node.op != Op::Min || is_first(id)) {
            least.push_back(id);
        } else {
            stack.insert(stack.end(), {node.b, node.a});
        }
    }
    return least;
}

Tape::Tape(std::shared_ptr<const TapeGraph> graph) : Tape(graph, graph->expr.root()) {}

Tape::Tape(std::shared_ptr<const TapeGraph> graph, NodeId root) {
    const std::vector<NodeId> order = in_order(*graph, root);
    std::vector<Index>& place = room().place_of_node;
    place.resize(graph->expr.nodes().size());
    std::vector<Step> steps;
    steps.reserve(order.size());
    std::size_t uniform = 0;
    for (const bool want_uniform : {true, false}) {
        for (const NodeId id : order) {
            if (graph->facts[id].uniform != want_uniform) continue;
            place[id] = static_cast<Index>(steps.size());
            Step& step = steps.emplace_back(Step{.node = id, .slot = 0, .operands = {}});
            for (std::size_t k = 0; k < operand_count(*graph, id); ++k)
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

/// What the steps of a tape come to where its choices fall in a known way.
class Tape::Reduction {
public:
    Reduction(const Tape& tape, const ChoiceRecord& record, std::span<const std::size_t> cells)
        : tape_(tape),
          stands_for_(room().stands_for),
          switches_(room().switches),
          zero_(room().zero) {
        stands_for_.resize(tape.steps_.size());
        switches_.resize(tape.steps_.size());
        zero_.resize(tape.steps_.size());
        for (Index i = 0; i < tape.steps_.size(); ++i)
            reduce(i, record, cells);
    }

    /// For each step, the one whose value may be taken instead.
    [[nodiscard]] std::span<const Index> stands_for() const { return stands_for_; }
    [[nodiscard]] std::span<const SwitchIndex> switches() const { return switches_; }
    [[nodiscard]] bool any() const { return any_; }

private:
    void reduce(Index i, const ChoiceRecord& record, std::span<const std::size_t> cells);
    /// The operand that the step's value is.
    [[nodiscard]] std::optional<Index> same_as(const Step& step, const ChoiceRecord& record,
                                               std::span<const std::size_t> cells) const;
    /// The other operand of a sum with 0.
    [[nodiscard]] std::optional<Index> summand(const Step& step) const;
    [[nodiscard]] bool is_zero(const Step& step) const;

    const Tape& tape_;
    std::vector<Index>& stands_for_;
    std::vector<SwitchIndex>& switches_;
    std::vector<std::uint8_t>& zero_;   ///< whether the value is the number 0
    std::optional<Index> number_zero_;  ///< a constant
    bool any_ = false;
};

void Tape::Reduction::reduce(Index i, const ChoiceRecord& record,
                             std::span<const std::size_t> cells) {
    const Step& step = tape_.steps_[i];
    stands_for_[i] = i;
    switches_[i] = step.own_switch;
    zero_[i] = tape_.sums_ && is_zero(step) ? 1 : 0;
    if (zero_[i] != 0 && i < tape_.uniform_) number_zero_ = i;
    std::optional<Index> taken;
    if (zero_[i] != 0 && any_) taken = number_zero_;
    if (!taken) taken = same_as(step, record, cells);
    if (!taken || *taken == i) return;
    // What is built on it may rely on that.
    if (tape_.facts(step).nonnegative && !tape_.facts(tape_.steps_[*taken]).nonnegative) return;
    stands_for_[i] = *taken;
    // Where the conditions are the same, so are the outcomes.
    const bool varies = *taken >= tape_.uniform_;
    if (varies && is_condition(tape_.node(step).op) && switches_[*taken] == no_switch)
        switches_[*taken] = step.own_switch;
    zero_[i] = zero_[*taken];
    any_ = true;
}

std::optional<Index> Tape::Reduction::same_as(const Step& step, const ChoiceRecord& record,
                                              std::span<const std::size_t> cells) const {
    if (step.choice == no_choice) return summand(step);
    const std::optional<std::size_t> which = winner(record, step.choice, cells);
    if (!which && step.heeds != no_choice && winner(record, step.heeds, cells)) {
        const Index a = step.operands[0];
        return zero_[a] != 0 ? a : step.operands[1];
    }
    if (!which) return std::nullopt;
    return stands_for_[alternative(tape_.node(step).op, step, *which)];
}

std::optional<Index> Tape::Reduction::summand(const Step& step) const {
    if (!any_ || !tape_.sums_) return std::nullopt;
    const Op op = tape_.node(step).op;
    if (!is_sum(op) || tape_.graph_->is_first(step.node)) return std::nullopt;
    const Index a = stands_for_[step.operands[0]];
    const Index b = stands_for_[step.operands[1]];
    if (zero_[b] != 0) return a;
    return op == Op::Add && zero_[a] != 0 ? std::optional(b) : std::nullopt;
}

bool Tape::Reduction::is_zero(const Step& step) const {
    const Facts& facts = tape_.facts(step);
    if (facts.exact()) return facts.constant->hi == 0;
    if (tape_.graph_->is_first(step.node)) return false;
    const Node& node = tape_.node(step);
    const auto operand_is_zero = [&](std::size_t k) {
        return zero_[stands_for_[step.operands[k]]] != 0;
    };
    const auto nonzero_constant = [&](std::size_t k) {
        const auto& box = tape_.facts(tape_.steps_[step.operands[k]]).constant;
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

std::optional<Tape> Tape::specialized(const ChoiceRecord& record,
                                      std::span<const std::size_t> cells) const {
    const Reduction reduction(*this, record, cells);
    if (!reduction.any()) return std::nullopt;
    const std::span<const Index> stands_for = reduction.stands_for();
    return Builder(steps_, uniform_, stands_for, reduction.switches())
        .build(graph_, stands_for[steps_.size() - 1]);
}

}  // namespace zeroset
