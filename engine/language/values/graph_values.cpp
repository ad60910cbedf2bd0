// Errors, the budget, and what is known of nodes.

#include "engine/language/values/graph_values.hpp"

#include "engine/algebra/graph_facts.hpp"
#include "engine/base/translation.hpp"

#include <string>
#include <utility>

namespace zeroset {
namespace {

constexpr std::size_t max_steps = 10'000'000;  // takes less than two seconds

std::string why_undefined(const Node& node) {
    if (node.op == Op::Divide) return tr("this is not a number: a division by 0");
    if (node.op == Op::Mod) return filled(tr("this is not a number: {0}"), {"mod(a, 0)"});
    if (node.op == Op::Where) return tr("this is not a number: its condition never holds");
    return filled(tr("this is not a number: {0} outside its domain"), {op_info(node.op).spelling});
}

}  // namespace

std::nullopt_t GraphValues::fail(ParseError error) {
    if (!error_) {
        error_ = std::move(error);
        wanted_vector_ = false;
    }
    return std::nullopt;
}

std::nullopt_t GraphValues::fail(std::size_t offset, std::string reason, std::string hint) {
    return fail({.offset = offset, .reason = std::move(reason), .hint = std::move(hint)});
}

std::nullopt_t GraphValues::fail_for_vector(std::size_t offset, std::string reason,
                                            std::string hint) {
    const bool is_first = !error_;
    fail(offset, std::move(reason), std::move(hint));
    wanted_vector_ = wanted_vector_ || is_first;
    return std::nullopt;
}

std::unexpected<ParseError> GraphValues::failure() {
    return std::unexpected(*std::exchange(error_, std::nullopt));
}

std::unexpected<ParseError> GraphValues::failure(std::size_t offset, std::string reason,
                                                 std::string hint) {
    fail(offset, std::move(reason), std::move(hint));
    return failure();
}

GraphValues::Built GraphValues::done(NodeId id, std::size_t offset, bool condition) {
    if (builder_.size() > ProgramLimits::nodes) {
        return fail(offset, filled(tr("the formula has more than {0} operations"),
                                   {std::to_string(ProgramLimits::nodes)}));
    }
    for (auto next = static_cast<NodeId>(facts_.size()); next < builder_.size(); ++next) {
        facts_.push_back(facts_of_node(builder_.node(next), facts_));
        const Node& node = builder_.node(next);
        if (refuses_undefined_ && (facts_.back().undefined || divides_by_zero(node)))
            return fail(offset, why_undefined(node));
    }
    return BuiltValue{.id = id, .condition = condition};
}

bool GraphValues::counts(std::size_t offset) {
    if (++steps_ <= max_steps) return true;
    fail(offset, tr("the sums and functions here ask for too many operations"),
         tr("use fewer terms"));
    return false;
}

bool GraphValues::divides_by_zero(const Node& node) const {
    return (node.op == Op::Divide || node.op == Op::Mod) && is_zero(node.b);
}

bool GraphValues::is_zero(NodeId id) const {
    const auto& constant = facts_[id].constant;
    return constant && constant->neg_lo == 0 && constant->hi == 0;
}

bool GraphValues::never_holds(NodeId condition) const {
    const auto& constant = facts_[condition].constant;
    return constant && constant->hi <= 0;
}

std::optional<bool> GraphValues::known_truth(NodeId condition) const {
    const auto& constant = facts_[condition].constant;
    if (!constant || constant->neg_lo != -constant->hi) return std::nullopt;
    return constant->hi != 0;
}

std::optional<double> GraphValues::middle_of(NodeId id) const {
    return facts_[id].constant ? std::optional(facts_[id].middle) : std::nullopt;
}

}  // namespace zeroset
