// Divided differences: dd(f) = (f1 - f0)/delta for two values f1 and f0 of a function whose
// variables differ by constants, one of which is delta. See Reps and Rall, "Computational divided
// differencing and divided-difference arithmetics", Higher-Order and Symbolic Computation 16, 2003.

#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/rewrite/differences/differences.hpp"
#include "engine/rewrite/differences/inverse_slope.hpp"
#include "engine/rewrite/differences/kept_domain.hpp"
#include "engine/rewrite/differences/known_value.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <string_view>
#include <utility>

namespace zeroset {
namespace {

/// Larger steps are no derivative's.
constexpr double largest_step = 0.01;
constexpr int largest_power = 64;
constexpr std::size_t max_pairs = 4000;  ///< of nodes that are compared for one difference

double value_of(const Fraction& a) { return static_cast<double>(a.p) / static_cast<double>(a.q); }

/// A function of whole numbers or truth values: what differs is no small difference.
bool is_step(Op op) {
    return is_any_of(op, {Op::Sign, Op::Floor, Op::Ceil, Op::Round, Op::Less, Op::LessEqual,
                          Op::And, Op::Or, Op::Not});
}

/// The function of f1 and f0: nodes that are the same but for constant summands.
class DividedDifference {
public:
    DividedDifference(ExprBuilder& builder, NodeFacts& facts) : builder_(builder), facts_(facts) {}

    /// delta and dd(f); nothing where the two differ by more than small constants.
    std::optional<Difference> between(NodeId f1, NodeId f0) {
        if (is_step(builder_.node(f1).op) || step_between(builder_, f1, f0)) return std::nullopt;
        if (!alike(f1, f0) || !step_) return std::nullopt;
        if (std::abs(value_of(*step_)) > largest_step) return std::nullopt;
        delta_ = constant(*step_);
        return Difference{.delta = delta_, .divided = with_domain(of(f1, f0), f1, f0)};
    }

    /// dd(f) where the two values differ by a replaced node alone.
    std::optional<NodeId> replaced(NodeId f1, NodeId f0, const Replacement& leaf, NodeId delta) {
        leaf_ = Pair{leaf.from, leaf.by};
        delta_ = delta;
        if (!alike(f1, f0)) return std::nullopt;
        return with_domain(of(f1, f0), f1, f0);
    }

private:
    struct Rule;
    using Pair = std::pair<NodeId, NodeId>;
    /// The two values.
    struct Terms {
        Node to, from;
        NodeId f1, f0;
    };

    NodeId constant(const Fraction& value) { return constant_of(builder_, value); }
    NodeId zero() { return builder_.constant(0.0); }
    NodeId half_of(NodeId a) { return make_multiply(builder_, builder_.constant(0.5), a); }
    NodeId call(Op op, NodeId a, NodeId b = 0, NodeId c = 0) {
        return make_call(builder_, op, a, b, c);
    }
    NodeId times(NodeId a, NodeId b) {
        const bool nothing = a == zero() || b == zero();
        return nothing ? zero() : make_multiply(builder_, a, b);
    }
    NodeId choice(NodeId condition, NodeId a, NodeId b) {
        return a == b ? a : builder_.apply(Op::If, condition, a, b);
    }

    /// Whether the nodes are the same but for constant summands; finds the step.
    bool alike(NodeId f1, NodeId f0) {
        if (f1 == f0) return true;
        const auto [known, added] = alike_.try_emplace({f1, f0}, false);
        if (!added) return known->second;
        if (alike_.size() > max_pairs) return false;
        return alike_[{f1, f0}] = compare(f1, f0);
    }
    bool compare(NodeId f1, NodeId f0) {
        if (leaf_) {
            if (Pair{f1, f0} == *leaf_) return true;
        } else if (const auto step = step_between(builder_, f1, f0)) {
            if (!step_ && step->p != 0) step_ = step;
            return true;
        }
        const Node a = builder_.node(f1);
        const Node b = builder_.node(f0);
        if (a.op != b.op || a.number != b.number) return false;
        const bool has_sides =
            is_any_of(a.op, {Op::Abs, Op::Min, Op::Max, Op::If, Op::Mod, Op::Angle, Op::Atan2});
        if (leaf_ && has_sides) return false;  // the limit may differ from side to side
        if (a.op == Op::Multiply && leaf_ && is_known_zero(builder_, b.a)) return alike(a.a, b.a);
        if (a.op == Op::Multiply && leaf_ && is_known_zero(builder_, b.b)) return alike(a.b, b.b);
        if (is_step(a.op)) return true;
        if (leaf_ && is_inverse(a.op)) return alike(a.a, b.a);
        const Rule* rule = rule_of(a.op);
        return rule != nullptr && a.number <= largest_power && are_alike(*rule, a, b);
    }
    bool are_alike(const Rule& rule, const Node& a, const Node& b) {
        return std::ranges::all_of(rule.operands, [&](char operand) {
            if (operand == 'a') return alike(a.a, b.a);
            if (operand == 'b') return alike(a.b, b.b);
            if (operand == 'c') return alike(a.c, b.c);
            return a.b == b.b;  // '='
        });
    }

    NodeId of(NodeId f1, NodeId f0) {
        const auto known = known_.find({f1, f0});
        if (known != known_.end()) return known->second;
        const NodeId result = make(f1, f0);
        known_.emplace(Pair{f1, f0}, result);
        return result;
    }
    NodeId make(NodeId f1, NodeId f0) {
        if (f1 == f0) return zero();
        if (leaf_ && Pair{f1, f0} == *leaf_) return builder_.constant(1.0);
        if (const auto step = leaf_ ? std::nullopt : step_between(builder_, f1, f0)) {
            return ratio(builder_, constant(*step), delta_);
        }
        const Terms f{.to = builder_.node(f1), .from = builder_.node(f0), .f1 = f1, .f0 = f0};
        // Its slope holds the difference again, so that small ones stay.
        if (leaf_ && is_inverse(f.to.op)) return of_inverse(f);
        const Rule* rule = rule_of(f.to.op);
        return rule == nullptr ? plain(f) : (this->*rule->make)(f);
    }

    NodeId plain(const Terms& f) {
        return make_divide(builder_, make_subtract(builder_, f.f1, f.f0), delta_);
    }
    NodeId with_domain(NodeId function, NodeId f1, NodeId f0) {
        const std::array terms{f1, f0};
        // A leaf that is replaced has no domain of its own, and of_tangent divides.
        return leaf_ ? with_domain_of(builder_, facts_, function, std::span(terms).first(1),
                                      {Op::Tan, Op::Cot})
                     : with_domain_of(builder_, facts_, function, terms, {});
    }
    /// A part of f0 as a number where that is exactly known: 0 for 0*ln(0), which has no value.
    NodeId settled(NodeId part) {
        const auto known = leaf_ ? known_value(builder_, part) : std::nullopt;
        return known ? constant(*known) : part;
    }

    NodeId of_negative(const Terms& f) { return make_negate(builder_, of(f.to.a, f.from.a)); }
    NodeId of_sum(const Terms& f) {
        return make_add(builder_, of(f.to.a, f.from.a), of(f.to.b, f.from.b));
    }
    NodeId of_difference(const Terms& f) {
        return make_subtract(builder_, of(f.to.a, f.from.a), of(f.to.b, f.from.b));
    }
    NodeId of_product(const Terms& f) {
        if (leaf_ && is_known_zero(builder_, f.from.a)) return times(of(f.to.a, f.from.a), f.to.b);
        if (leaf_ && is_known_zero(builder_, f.from.b)) return times(f.to.a, of(f.to.b, f.from.b));
        return make_add(builder_, times(of(f.to.a, f.from.a), f.to.b),
                        times(settled(f.from.a), of(f.to.b, f.from.b)));
    }
    NodeId of_quotient(const Terms& f) {
        const NodeId top = make_subtract(builder_, of(f.to.a, f.from.a),
                                         times(settled(f.f0), of(f.to.b, f.from.b)));
        return make_divide(builder_, top, f.to.b);
    }
    NodeId of_power(const Terms& f) {
        return times(of(f.to.a, f.from.a), powers(f.to.a, settled(f.from.a), f.to.number));
    }
    /// (u^n - v^n)/(u - v)
    NodeId powers(NodeId u, NodeId v, int n) {
        if (n == 1) return builder_.constant(1.0);
        if (n % 2 == 0) {
            const NodeId sum = make_add(builder_, make_int_power(builder_, u, n / 2),
                                        make_int_power(builder_, v, n / 2));
            return make_multiply(builder_, sum, powers(u, v, n / 2));
        }
        return make_add(builder_, make_multiply(builder_, u, powers(u, v, n - 1)),
                        make_int_power(builder_, v, n - 1));
    }
    /// The difference p^(1/n) - q^(1/n) is (p - q) over the sum of powers of the roots, which is 0
    /// where both are.
    NodeId of_root(const Terms& f) {
        const NodeId top = of(f.to.a, f.from.a);
        const NodeId sum = powers(f.f1, settled(f.f0), f.to.op == Op::Sqrt ? 2 : f.to.number);
        const NodeId quotient = make_divide(builder_, top, sum);
        if (leaf_ || apart_at_zero(f.to.a, f.from.a)) return quotient;
        return choice(call(Op::LessEqual, sum, zero()), zero(), quotient);
    }
    /// Whether the two surely do not vanish at once.
    bool apart_at_zero(NodeId u, NodeId v) {
        const Node a = builder_.node(u);
        const Node b = builder_.node(v);
        if (const auto step = step_between(builder_, u, v)) return step->p != 0;
        if (a.op != b.op || a.number != b.number) return false;
        if (a.op == Op::Add) {
            const bool of_parts = facts_.is_nonnegative(a.a) && facts_.is_nonnegative(a.b) &&
                                  facts_.is_nonnegative(b.a) && facts_.is_nonnegative(b.b);
            return of_parts && (apart_at_zero(a.a, b.a) || apart_at_zero(a.b, b.b));
        }
        return is_any_of(a.op, {Op::IntPower, Op::Abs, Op::Sqrt}) && apart_at_zero(a.a, b.a);
    }

    /// One of two functions where both terms choose it, and the plain difference where they differ.
    NodeId agreed(const Terms& f, NodeId both_first, NodeId first, NodeId both_second,
                  NodeId second) {
        if (first == second) return first;
        return choice(both_first, first, choice(both_second, second, plain(f)));
    }
    NodeId both(Op op, Pair a, Pair b) {
        return call(Op::And, builder_.apply(op, a.first, b.first),
                    builder_.apply(op, a.second, b.second));
    }
    NodeId of_size(const Terms& f) {
        const Pair operands{f.to.a, f.from.a};
        const Pair zeros{zero(), zero()};
        const NodeId slope = of(f.to.a, f.from.a);
        if (slope == zero()) return zero();
        return agreed(f, both(Op::Less, zeros, operands), slope,
                      both(Op::LessEqual, operands, zeros), make_negate(builder_, slope));
    }
    NodeId of_extreme(const Terms& f) {
        const Pair left{f.to.a, f.from.a};
        const Pair right{f.to.b, f.from.b};
        const auto& [less, more] =
            f.to.op == Op::Min ? std::pair(left, right) : std::pair(right, left);
        const NodeId takes_left = both(Op::Less, less, more);
        const NodeId takes_right = both(Op::LessEqual, more, less);
        return agreed(f, takes_left, of(left.first, left.second), takes_right,
                      of(right.first, right.second));
    }
    NodeId of_choice(const Terms& f) {
        const NodeId first = with_domain(of(f.to.b, f.from.b), f.to.b, f.from.b);
        const NodeId second = with_domain(of(f.to.c, f.from.c), f.to.c, f.from.c);
        if (f.to.a == f.from.a) return choice(f.to.a, first, second);
        return agreed(f, call(Op::And, f.to.a, f.from.a), first,
                      call(Op::Not, call(Op::Or, f.to.a, f.from.a)), second);
    }
    NodeId of_restricted(const Terms& f) {
        return builder_.apply(Op::Where, of(f.to.a, f.from.a), call(Op::And, f.to.b, f.from.b));
    }
    NodeId of_remainder(const Terms& f) {
        const NodeId turns1 = call(Op::Floor, make_divide(builder_, f.to.a, f.to.b));
        const NodeId turns0 = call(Op::Floor, make_divide(builder_, f.from.a, f.from.b));
        const NodeId differ = call(Op::Or, builder_.apply(Op::Less, turns1, turns0),
                                   builder_.apply(Op::Less, turns0, turns1));
        return choice(differ, plain(f), of(f.to.a, f.from.a));
    }

    /// exp(u) - exp(v) = 2 exp(m) sinh(h) and its like, for u = m + h and v = m - h.
    NodeId of_wave(const Terms& f) {
        const NodeId slope = of(f.to.a, f.from.a);
        if (slope == zero()) return zero();
        const bool turns = is_any_of(f.to.op, {Op::Sin, Op::Cos});
        if (leaf_ && is_any_of(f.to.op, {Op::Sin, Op::Sinh}) && is_known_zero(builder_, f.from.a))
            return times(slope, cardinal_of(turns, f.to.a));
        const NodeId h = half_of(times(delta_, slope));
        const NodeId m = call(derivative(f.to.op), make_add(builder_, settled(f.from.a), h));
        const NodeId product = times(times(slope, m), cardinal_of(turns, h));
        return f.to.op == Op::Cos ? make_negate(builder_, product) : product;
    }
    NodeId cardinal_of(bool turns, NodeId h) {
        return builder_.apply(turns ? Op::Sinc : Op::Sinhc, h);
    }
    /// The derivative of sin, cos, sinh or cosh, but for its sign.
    static Op derivative(Op op) {
        constexpr std::array pairs{std::pair(Op::Sin, Op::Cos), std::pair(Op::Cos, Op::Sin),
                                   std::pair(Op::Sinh, Op::Cosh), std::pair(Op::Cosh, Op::Sinh)};
        const auto* pair = std::ranges::find(pairs, op, &std::pair<Op, Op>::first);
        return pair == pairs.end() ? op : pair->second;
    }
    NodeId of_inverse(const Terms& f) {
        const NodeId slope = of(f.to.a, f.from.a);
        if (slope == zero()) return zero();
        const NodeId q = settled(f.f0);
        const NodeId by = inverse_slope(
            builder_, {.op = f.to.op, .u = f.to.a, .v = settled(f.from.a), .p = f.f1, .q = q});
        const NodeId quotient = make_divide(builder_, slope, by);
        if (!is_any_of(f.to.op, {Op::Log, Op::Log10, Op::Log2})) return quotient;
        // Beside the end of the domain, where logarithms have no bound, the difference alone is
        // enclosed.
        const NodeId apart = make_subtract(builder_, f.f1, q);
        const NodeId near =
            builder_.apply(Op::Less, make_int_power(builder_, apart, 2), builder_.constant(1.0));
        return choice(near, quotient, plain(f));
    }
    /// tan(u) - tan(v) = sin(u - v) / (cos(u) cos(v)), and cot and tanh alike.
    NodeId of_tangent(const Terms& f) {
        const NodeId slope = of(f.to.a, f.from.a);
        const Op below = f.to.op == Op::Tan ? Op::Cos : f.to.op == Op::Cot ? Op::Sin : Op::Cosh;
        const NodeId top = times(slope, cardinal_of(f.to.op != Op::Tanh, times(delta_, slope)));
        const NodeId quotient = make_divide(
            builder_, top,
            make_multiply(builder_, call(below, f.to.a), call(below, settled(f.from.a))));
        return f.to.op == Op::Cot ? make_negate(builder_, quotient) : quotient;
    }
    /// atan(u) - atan(v) = atan((u - v)/(1 + u v)), if that is above 0.
    NodeId of_arc(const Terms& f) {
        const NodeId along = make_add(builder_, builder_.constant(1.0),
                                      make_multiply(builder_, f.to.a, settled(f.from.a)));
        return of_turn(f, of(f.to.a, f.from.a), along, builder_.constant(1.0));
    }
    /// The difference of the angles of two points.
    NodeId of_angle(const Terms& f) {
        const NodeId across = make_subtract(builder_, times(of(f.to.a, f.from.a), f.from.b),
                                            times(of(f.to.b, f.from.b), f.from.a));
        const NodeId along = make_add(builder_, make_multiply(builder_, f.to.b, f.from.b),
                                      make_multiply(builder_, f.to.a, f.from.a));
        if (f.to.op == Op::Angle) return of_turn(f, across, along, builder_.constant(1.0));
        return of_turn(f, across, along, on_one_side({f.to.a, f.from.a}, {f.to.b, f.from.b}));
    }
    /// Whether the cut of atan2 does not lie between two points that are seen within a right angle.
    NodeId on_one_side(Pair y, Pair x) {
        if (facts_.is_nonnegative(x.first) && facts_.is_nonnegative(x.second)) {
            return builder_.constant(1.0);
        }
        const Pair zeros{zero(), zero()};
        const NodeId sides = call(Op::Or, both(Op::Less, y, zeros), both(Op::LessEqual, zeros, y));
        return call(Op::Or, builder_.apply(Op::Less, zero(), x.second), sides);
    }
    NodeId of_turn(const Terms& f, NodeId across, NodeId along, NodeId uncut) {
        const NodeId tangent = make_divide(builder_, across, along);
        const NodeId cardinal = builder_.apply(Op::Atanc, times(delta_, tangent));
        const NodeId near = builder_.apply(Op::Less, zero(), along);
        const bool always = uncut == builder_.constant(1.0);
        return choice(always ? near : call(Op::And, near, uncut), times(tangent, cardinal),
                      plain(f));
    }

    struct Rule {
        Op op;
        std::string_view operands;  ///< those that may differ; "=": b may not
        NodeId (DividedDifference::*make)(const Terms&);

        constexpr Rule(Op of, std::string_view differing,
                       NodeId (DividedDifference::*by)(const Terms&))
            : op(of), operands(differing), make(by) {}
    };
    static const Rule* rule_of(Op op) {
        using D = DividedDifference;
        static constexpr std::array rules{Rule{Op::Negate, "a", &D::of_negative},
                                          Rule{Op::Add, "ab", &D::of_sum},
                                          Rule{Op::Subtract, "ab", &D::of_difference},
                                          Rule{Op::Multiply, "ab", &D::of_product},
                                          Rule{Op::Divide, "ab", &D::of_quotient},
                                          Rule{Op::IntPower, "a", &D::of_power},
                                          Rule{Op::OddRoot, "a", &D::of_root},
                                          Rule{Op::Sqrt, "a", &D::of_root},
                                          Rule{Op::Abs, "a", &D::of_size},
                                          Rule{Op::Min, "ab", &D::of_extreme},
                                          Rule{Op::Max, "ab", &D::of_extreme},
                                          Rule{Op::If, "bc", &D::of_choice},
                                          Rule{Op::Where, "a", &D::of_restricted},
                                          Rule{Op::Mod, "a=", &D::of_remainder},
                                          Rule{Op::Exp, "a", &D::of_wave},
                                          Rule{Op::Sin, "a", &D::of_wave},
                                          Rule{Op::Cos, "a", &D::of_wave},
                                          Rule{Op::Sinh, "a", &D::of_wave},
                                          Rule{Op::Cosh, "a", &D::of_wave},
                                          Rule{Op::Tan, "a", &D::of_tangent},
                                          Rule{Op::Cot, "a", &D::of_tangent},
                                          Rule{Op::Tanh, "a", &D::of_tangent},
                                          Rule{Op::Atan, "a", &D::of_arc},
                                          Rule{Op::Angle, "ab", &D::of_angle},
                                          Rule{Op::Atan2, "ab", &D::of_angle}};
        const auto* rule = std::ranges::find(rules, op, &Rule::op);
        return rule == rules.end() ? nullptr : rule;
    }

    ExprBuilder& builder_;
    NodeFacts& facts_;
    std::map<Pair, bool> alike_;
    std::map<Pair, NodeId> known_;
    std::optional<Fraction> step_;
    std::optional<Pair> leaf_;  ///< the replaced node and what replaces it
    NodeId delta_ = 0;
};

}  // namespace

std::optional<NodeId> divided_difference(ExprBuilder& builder, NodeFacts& facts, NodeId f, NodeId g,
                                         const Replacement& replaced, NodeId delta) {
    return DividedDifference(builder, facts).replaced(f, g, replaced, delta);
}

std::optional<Difference> divided_difference(ExprBuilder& builder, NodeFacts& facts, NodeId f1,
                                             NodeId f0) {
    return DividedDifference(builder, facts).between(f1, f0);
}

}  // namespace zeroset
