#include "engine/rewrite/polynomial/tighten.hpp"

#include "engine/algebra/graph_facts.hpp"
#include "engine/expr/copy.hpp"
#include "engine/real/rounding.hpp"
#include "engine/rewrite/polynomial/polynomial.hpp"
#include "engine/rewrite/polynomial/polynomial_candidates.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t most_nodes_tightened = 2000;
// A better form of one part may let another one pay.
constexpr int max_rounds = 3;
constexpr std::size_t max_new_nodes = 300;  ///< for one subexpression
constexpr std::size_t max_effort = 1900;    ///< nodes evaluated, in all

double cost_of_power(int exponent, bool nonnegative) {
    const auto n = static_cast<unsigned>(exponent);
    const double squarings = std::bit_width(n) - 1.0;
    const double products = std::popcount(n) - 1.0;
    return (nonnegative ? 0.0 : 1.5) + squarings + 2.0 * products;
}

/// Time of an operator that is no leaf, in additions; roughly what the machine code needs.
double cost_of(const Node& node, std::span<const Facts> facts) {
    const Facts& a = facts[node.a];
    const Facts& b = facts[node.b];
    if (node.op == Op::Negate) return 0.2;
    if (node.op == Op::Add || node.op == Op::Subtract) return 1.0;
    if (node.op == Op::IntPower) return cost_of_power(node.number, a.nonnegative);
    if (node.op != Op::Multiply) return 10.0;
    if (a.constant || b.constant) return 1.0;
    if (a.nonnegative && b.nonnegative) return 2.0;
    return a.nonnegative || b.nonnegative ? 3.5 : 6.0;
}

/// The time that a cell of a search for the zeros of a node takes, in additions.
double time_of_cell(const Expr& expr, NodeId root, std::span<const Facts> facts) {
    double time = 10.0;  // of the tracer
    std::vector<bool> used(root + 1);
    used[root] = true;
    for (NodeId id = root + 1; id-- > 0;) {
        const Node& node = expr.node(id);
        if (!used[id] || facts[id].constant || node.op == Op::Variable) continue;
        time += cost_of(node, facts);
        used[node.a] = true;
        used[node.b] = true;
        used[node.c] = true;
    }
    return time;
}

/// Several graphs with their common nodes only once, and what a search would cost with each.
class Contest {
public:
    Contest(ExprBuilder& builder, std::span<const NodeId> roots) {
        NodeId chain = roots.front();
        for (const NodeId root : roots.subspan(1))
            chain = builder.apply(Op::Min, chain, root);
        joint_ = builder.finish(chain);
        NodeId link = joint_.root();
        for (std::size_t i = roots.size(); i-- > 1; link = joint_.node(link).a)
            roots_.push_back(joint_.node(link).b);
        roots_.push_back(link);
        std::ranges::reverse(roots_);
    }

    [[nodiscard]] std::size_t size() const { return joint_.nodes().size(); }

    /// The index of the one to take; the first unless another one is clearly better.
    [[nodiscard]] std::size_t best(const BoxSample& sample) const {
        const std::vector<Rating> ratings = rate(sample, 1);
        std::size_t best = 0;
        double best_time = clearly * ratings.front().time;
        for (std::size_t i = 1; i < ratings.size(); ++i) {
            if (ratings[i].boxes > ratings.front().boxes || !(ratings[i].time < best_time))
                continue;
            best_time = ratings[i].time;
            best = i;
        }
        return best;
    }

    /// The first and the most promising others by a part of the sample.
    [[nodiscard]] std::vector<std::size_t> finalists(const BoxSample& sample) const {
        const std::vector<Rating> ratings = rate(sample, screening_stride);
        std::vector<std::size_t> order(ratings.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto time = [&](std::size_t i) { return ratings[i].time; };
        std::ranges::stable_sort(order.begin() + 1, order.end(), std::ranges::less{}, time);
        order.resize(std::min(order.size(), max_finalists));
        return order;
    }

private:
    static constexpr double clearly = 0.97;
    static constexpr double width_weight = 0.1;  ///< widths decide where the boxes are the same
    static constexpr std::size_t screening_stride = 6;
    static constexpr std::size_t max_finalists = 4;

    struct Rating {
        double boxes;
        double time;
    };

    [[nodiscard]] std::vector<Rating> rate(const BoxSample& sample, std::size_t stride) const {
        const std::vector<Facts> facts = facts_of(joint_);
        const auto works = sample.work(joint_, facts, roots_, stride);
        std::vector<Rating> ratings;
        for (std::size_t i = 0; i < roots_.size(); ++i) {
            const double cost = time_of_cell(joint_, roots_[i], facts);
            const auto [boxes, width] = works[i];
            ratings.push_back(
                {.boxes = boxes, .time = cost * (1.0 + boxes + width_weight * width)});
        }
        return ratings;
    }

    Expr joint_;
    std::vector<NodeId> roots_;
};

class Tightener {
public:
    /// Adds what it does to `effort`, in nodes evaluated.
    Tightener(const Expr& expr, const SampleRegion& region, std::size_t& effort)
        : expr_(expr),
          facts_(facts_of(expr)),
          expansion_(expand(expr, facts_)),
          sample_(expr, facts_, region),
          now_(expr.nodes().size()),
          replaced_(expr.nodes().size()),
          effort_(effort) {
        for (NodeId id = 0; id <= expr.root(); ++id)
            now_[id] = copy_node(builder_, expr.node(id), now_);
    }

    Expr run() {
        for (const NodeId id : sums())
            choose(id);
        const auto names = expr_.parameters();
        return builder_.finish(now_.back(), {names.begin(), names.end()});
    }

private:
    /// Polynomials that are no summands of one, and those that are no operands of one; the largest
    /// first.
    [[nodiscard]] std::vector<NodeId> sums() const {
        const auto is_sum = [&](NodeId id) {
            return expr_.node(id).op == Op::Add || expr_.node(id).op == Op::Subtract;
        };
        std::vector<bool> wanted(expr_.nodes().size());
        wanted[expr_.root()] = true;
        for (NodeId id = 0; id <= expr_.root(); ++id) {
            if (facts_[id].constant) continue;
            const Node& node = expr_.node(id);
            const bool polynomial = is_polynomial_operator(expr_, facts_, id);
            for (const NodeId operand : {node.a, node.b, node.c}) {
                if (!polynomial || (!is_sum(id) && is_sum(operand))) wanted[operand] = true;
            }
        }
        std::vector<NodeId> result;
        for (NodeId id = expr_.root() + 1; id-- > 0;) {
            if (wanted[id] && is_polynomial_operator(expr_, facts_, id)) result.push_back(id);
        }
        return result;
    }

    /// Replaces node `id` by the best of its forms.
    void choose(NodeId id) {
        if (effort_ >= max_effort) return;
        const std::vector<NodeId> above = nodes_above(id);
        if (id != expr_.root() && (above.empty() || above.back() != expr_.root())) return;
        const AnalysedExpr graph{.expr = expr_, .facts = facts_, .expansion = expansion_};
        std::vector<NodeId> candidates{now_[id]};
        const std::size_t room = std::min(max_new_nodes, max_effort - effort_);
        for (const NodeId node : polynomial_candidates(builder_, graph, now_, id, room)) {
            if (std::ranges::find(candidates, node) == candidates.end()) candidates.push_back(node);
        }
        if (candidates.size() == 1) return;
        const Contest all(builder_, roots_with(id, candidates, above));
        std::vector<NodeId> finalists;
        for (const std::size_t index : all.finalists(sample_))
            finalists.push_back(candidates[index]);
        const Contest final_round(builder_, roots_with(id, finalists, above));
        // To write a candidate costs about as much as to evaluate three nodes.
        effort_ += all.size() + final_round.size() + 3 * candidates.size();
        const std::size_t best = final_round.best(sample_);
        replace(id, finalists[best], above);
        replaced_[id] = best != 0;
    }

    /// The roots that come of each of the candidates for node `id`.
    std::vector<NodeId> roots_with(NodeId id, std::span<const NodeId> candidates,
                                   std::span<const NodeId> above) {
        std::vector<NodeId> roots;
        for (const NodeId node : candidates) {
            replace(id, node, above);
            roots.push_back(now_.back());
        }
        return roots;
    }

    void replace(NodeId id, NodeId by, std::span<const NodeId> above) {
        now_[id] = by;
        for (const NodeId user : above)
            now_[user] = copy_node(builder_, expr_.node(user), now_);
    }

    /// Nodes that depend on node `id` and stand as they were typed, operands first.
    [[nodiscard]] std::vector<NodeId> nodes_above(NodeId id) const {
        std::vector<bool> depends(expr_.nodes().size());
        depends[id] = true;
        std::vector<NodeId> result;
        for (NodeId user = id + 1; user <= expr_.root(); ++user) {
            const Node& node = expr_.node(user);
            const bool used = depends[node.a] || depends[node.b] || depends[node.c];
            depends[user] = arity(node.op) > 0 && !replaced_[user] && used;
            if (depends[user]) result.push_back(user);
        }
        return result;
    }

    const Expr& expr_;
    std::vector<Facts> facts_;
    Expansion expansion_;
    BoxSample sample_;
    ExprBuilder builder_;
    std::vector<NodeId> now_;
    std::vector<bool> replaced_;
    std::size_t& effort_;
};

}  // namespace

double time_of_cell(const Expr& expr) {
    const UpwardRounding upward;
    return time_of_cell(expr, expr.root(), facts_of(expr));
}

Expr tightened(const Expr& expr, const SampleRegion& region) {
    if (expr.nodes().size() > most_nodes_tightened) return expr;
    const UpwardRounding upward;
    Expr best = expr;
    std::size_t effort = 0;
    for (int round = 0; round < max_rounds && effort < max_effort; ++round) {
        Expr next = Tightener(best, region, effort).run();
        if (next.key() == best.key()) break;
        best = std::move(next);
    }
    return best;
}

}  // namespace zeroset
