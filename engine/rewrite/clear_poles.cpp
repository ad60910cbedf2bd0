// Quotients of pole-free numerators and denominators.
//
// Each node from the root down to the first that is no sum, product, power or quotient is written
// as N / (b1^n1 b2^n2 ...) over bases b that vanish along surfaces. A base whose powers cancel
// stays with the exponent 0: where it vanishes, the formula is undefined.

#include "engine/algebra/graph_facts.hpp"
#include "engine/expr/copy.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/real/rounding.hpp"
#include "engine/rewrite/passes.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t max_nodes = 1000;
constexpr std::size_t max_bases = 6;  ///< each makes products of all others
constexpr int max_exponent = 64;
// Between a curve's share of cells and a surface's, see BoxSample::share_with_zeros.
constexpr double share_of_surface = 0x1p-13;

struct Power {
    NodeId base;
    int exponent;
};

/// top / (bases to their exponents).
struct Quotient {
    NodeId top;
    std::vector<Power> bottom;
};

class PoleClearer {
public:
    PoleClearer(const Expr& expr, const SampleRegion& region)
        : expr_(expr), facts_(facts_of(expr)), region_(region), quotients_(expr.nodes().size()) {}

    /// Nothing if there is nothing to clear, or it would take too much.
    std::optional<Expr> run() {
        mark();
        if (!has_divisions_) return std::nullopt;
        for (NodeId id = 0; id <= expr_.root(); ++id) {
            quotients_[id] =
                opened_[id] ? quotient_of(id) : Quotient{.top = copied(id), .bottom = {}};
            if (too_large_ || builder_.size() > 3 * expr_.nodes().size() + 100) return std::nullopt;
        }
        if (!cleared_) return std::nullopt;
        const auto names = expr_.parameters();
        return builder_.finish(root_of(expr_.root()), {names.begin(), names.end()});
    }

private:
    static bool is_quotient(Op op) { return op == Op::Divide || op == Op::Tan || op == Op::Cot; }
    static bool is_rational(Op op) {
        return is_quotient(op) || op == Op::Negate || op == Op::Add || op == Op::Subtract ||
               op == Op::Multiply || op == Op::IntPower;
    }

    /// Finds the nodes above which there are only rational operators; restrictions of the whole are
    /// left outside.
    void mark() {
        opened_.assign(expr_.nodes().size(), false);
        NodeId root = expr_.root();
        while (expr_.node(root).op == Op::Where)
            root = expr_.node(root).a;
        std::vector<bool> reached(expr_.nodes().size());
        reached[root] = true;
        for (NodeId id = root + 1; id-- > 0;) {
            const Node& node = expr_.node(id);
            opened_[id] = reached[id] && is_rational(node.op) && !facts_[id].uniform;
            if (!opened_[id]) continue;
            has_divisions_ = has_divisions_ || is_quotient(node.op);
            reached[node.a] = true;
            if (arity(node.op) == 2) reached[node.b] = true;
        }
    }

    /// The node as it was, over the copies of its operands.
    NodeId copied(NodeId id) {
        return copy_node(builder_, expr_.node(id),
                         [&](NodeId operand) { return copy_of(operand); });
    }
    /// An operand that is no part of the rational function is copied whole, poles and all.
    NodeId copy_of(NodeId id) {
        if (!opened_[id]) return quotients_[id]->top;
        auto known = copies_.find(id);
        if (known == copies_.end()) known = copies_.emplace(id, copied(id)).first;
        return known->second;
    }
    /// The whole formula again: the quotient, below its restrictions.
    NodeId root_of(NodeId id) {
        const Node& node = expr_.node(id);
        if (node.op == Op::Where) {
            return builder_.apply(Op::Where, root_of(node.a), copy_of(node.b));
        }
        NodeId result = quotients_[id]->top;
        for (const Power& power : quotients_[id]->bottom) {
            if (power.exponent % 2 == 0) result = where_not_zero(result, power.base);
        }
        for (const Power& power : quotients_[id]->bottom) {
            if (power.exponent % 2 != 0) result = builder_.apply(Op::Oriented, result, power.base);
        }
        return result;
    }
    NodeId where_not_zero(NodeId a, NodeId base) {
        const NodeId zero = builder_.constant(0.0);
        const NodeId below = builder_.apply(Op::Less, base, zero);
        const NodeId above = builder_.apply(Op::Less, zero, base);
        return builder_.apply(Op::Where, a, builder_.apply(Op::Or, below, above));
    }

    Quotient quotient_of(NodeId id) {
        const Node& node = expr_.node(id);
        const Quotient& a = *quotients_[node.a];
        if (node.op == Op::Negate) return {.top = make_negate(builder_, a.top), .bottom = a.bottom};
        if (node.op == Op::IntPower) return power(a, node.number);
        if (node.op == Op::Tan || node.op == Op::Cot) return tangent(node);
        const Quotient& b = *quotients_[node.b];
        if (node.op == Op::Multiply) {
            std::vector<Power> bottom = product(a.bottom, b.bottom);
            const NodeId left = without_common(a.top, bottom);
            const NodeId right = without_common(b.top, bottom);
            return {.top = make_multiply(builder_, left, right), .bottom = std::move(bottom)};
        }
        if (node.op == Op::Divide) return quotient(a, b);
        return sum(node.op, a, b);
    }

    Quotient power(const Quotient& a, int n) {
        Quotient result{.top = make_int_power(builder_, a.top, n), .bottom = a.bottom};
        for (Power& power : result.bottom) {
            if (power.exponent > max_exponent / n) too_large_ = true;
            power.exponent *= too_large_ ? 1 : n;
        }
        return result;
    }

    Quotient tangent(const Node& node) {
        const NodeId a = copy_of(node.a);
        const NodeId sine = make_call(builder_, Op::Sin, a);
        const NodeId cosine = make_call(builder_, Op::Cos, a);
        const bool tan = node.op == Op::Tan;
        const NodeId base = tan ? cosine : sine;
        if (!vanishes_on_surface(base)) return {.top = builder_.apply(node.op, a), .bottom = {}};
        cleared_ = true;
        return {.top = tan ? sine : cosine, .bottom = {{.base = base, .exponent = 1}}};
    }

    Quotient quotient(const Quotient& a, const Quotient& b) {
        Quotient result = a;
        for (Power power : b.bottom) {
            result.top = make_multiply(builder_, result.top, power_of(power));
            power.exponent = 0;
            result.bottom = product(result.bottom, std::array{power});
        }
        const NodeId rest = divide(result, b.top, 1);
        result.top = make_divide(builder_, without_common(result.top, result.bottom), rest);
        return result;
    }
    /// Takes the factors of a divisor that vanish along surfaces into the quotient's bottom;
    /// returns the product of the others.
    NodeId divide(Quotient& a, NodeId id, int exponent) {
        const Node node = builder_.node(id);
        if (node.op == Op::Multiply) {
            const NodeId left = divide(a, node.a, exponent);
            return make_multiply(builder_, left, divide(a, node.b, exponent));
        }
        if (node.op == Op::IntPower && node.number <= max_exponent / exponent) {
            return divide(a, node.a, exponent * node.number);
        }
        if (!vanishes_on_surface(id)) return make_int_power(builder_, id, exponent);
        cleared_ = true;
        a.bottom = product(a.bottom, std::array{Power{.base = id, .exponent = exponent}});
        return builder_.constant(1.0);
    }
    /// The factor without the powers that it has in common with the bottom, which loses them, too.
    NodeId without_common(NodeId top, std::vector<Power>& bottom) {
        const Node node = builder_.node(top);
        if (node.op == Op::Multiply) {
            const NodeId left = without_common(node.a, bottom);
            return make_multiply(builder_, left, without_common(node.b, bottom));
        }
        const bool is_power = node.op == Op::IntPower;
        const auto same = std::ranges::find(bottom, is_power ? node.a : top, &Power::base);
        if (same == bottom.end()) return top;
        const int exponent = is_power ? node.number : 1;
        const int common = std::min(exponent, same->exponent);
        same->exponent -= common;
        return make_int_power(builder_, same->base, exponent - common);
    }

    Quotient sum(Op op, const Quotient& a, const Quotient& b) {
        const std::vector<Power> bottom = common(a.bottom, b.bottom);
        const NodeId left = over(a, bottom);
        const NodeId right = over(b, bottom);
        return {.top = op == Op::Add ? make_add(builder_, left, right)
                                     : make_subtract(builder_, left, right),
                .bottom = bottom};
    }
    /// The top of the same quotient over a multiple of its bottom.
    NodeId over(const Quotient& a, std::span<const Power> bottom) {
        NodeId top = a.top;
        for (Power power : bottom) {
            for (const Power& own : a.bottom) {
                if (own.base == power.base) power.exponent -= own.exponent;
            }
            if (power.exponent > 0) top = make_multiply(builder_, top, power_of(power));
        }
        return top;
    }
    NodeId power_of(const Power& power) {
        return make_int_power(builder_, power.base, power.exponent);
    }

    std::vector<Power> product(std::vector<Power> a, std::span<const Power> b) {
        return merged(std::move(a), b, [](int m, int n) { return m + n; });
    }
    std::vector<Power> common(std::vector<Power> a, std::span<const Power> b) {
        return merged(std::move(a), b, [](int m, int n) { return std::max(m, n); });
    }
    std::vector<Power> merged(std::vector<Power> a, std::span<const Power> b, auto exponent_of) {
        for (const Power& power : b) {
            const auto known = std::ranges::find(a, power.base, &Power::base);
            if (known == a.end()) {
                a.push_back(power);
            } else {
                known->exponent = exponent_of(known->exponent, power.exponent);
            }
        }
        const bool high = std::ranges::any_of(
            a, [](const Power& power) { return power.exponent > max_exponent; });
        too_large_ = too_large_ || high || a.size() > max_bases;
        return a;
    }

    /// Whether a node of the new graph does so somewhere in the region.
    bool vanishes_on_surface(NodeId id) {
        const auto known = on_surface_.find(id);
        if (known != on_surface_.end()) return known->second;
        const UpwardRounding upward;
        const Expr divisor = builder_.finish(id);
        const std::vector<Facts> facts = facts_of(divisor);
        const bool result =
            !facts.back().uniform &&
            BoxSample(divisor, facts, region_).share_with_zeros() > share_of_surface;
        on_surface_.emplace(id, result);
        return result;
    }

    const Expr& expr_;
    std::vector<Facts> facts_;
    const SampleRegion& region_;
    std::vector<std::optional<Quotient>> quotients_;
    std::vector<bool> opened_;  ///< the nodes that are written as quotients
    std::unordered_map<NodeId, NodeId> copies_;
    std::unordered_map<NodeId, bool> on_surface_;
    ExprBuilder builder_;
    bool has_divisions_ = false;
    bool cleared_ = false;
    bool too_large_ = false;
};

}  // namespace

Expr without_poles(const Expr& expr, const SampleRegion& region) {
    if (expr.nodes().size() > max_nodes) return expr;
    return PoleClearer(expr, region).run().value_or(expr);
}

}  // namespace zeroset
