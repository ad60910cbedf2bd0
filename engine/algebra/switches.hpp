#pragma once

#include "engine/algebra/facts.hpp"
#include "engine/expr/expr.hpp"
#include "engine/num/enclosure.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

// Switches: operators with jumps at known places (floor, ceil, round, sign, mod, conditions, atan2
// at its cut; of conditions made of others the outermost one). Between the jumps each has one
// outcome, a whole number, and f is one smooth piece. In a box where a switch has two or three
// outcomes, a piece is f with the switch held at one of them: wherever a point of the box has that
// outcome, the piece is f.

namespace zeroset {

using SwitchIndex = std::uint32_t;
inline constexpr SwitchIndex no_switch = std::numeric_limits<SwitchIndex>::max();

bool is_switch(Op op);
/// Comparisons and what makes conditions of conditions.
bool is_condition(Op op);
/// Whether the operator has a kink: abs, min, max.
bool has_kink(Op op);
/// Whether any node of the graph is a switch or has a kink.
bool has_branches(const Expr& expr);

/// For each node its place among the graph's switches, operands first, or no_switch. A switch that
/// is the same in a whole batch has none.
std::vector<SwitchIndex> switches_of(const Expr& expr, std::span<const Facts> facts);

/// How many of these are switches.
std::size_t count_switches(std::span<const SwitchIndex> switches);

/// Where a switch is held at an outcome, if it has two or three there; and which, from 0 on.
template <class Real>
struct HeldAt {
    using Mask = typename Enclosure<Real>::Mask;

    Mask of_two, of_three;
    Real outcome;
};

/// A stretch of a ray, in et of its cell; empty where from > to.
template <class Real>
struct Cut {
    Real from, to;
};

/// The first of the cut and, where `open` holds, the stretch of [-1, 1] within `aside` of `at`.
template <class Real>
Cut<Real> first_cut(const Cut<Real>& cut, const typename Enclosure<Real>::Mask& open,
                    const Real& at, const Real& aside) {
    const Real one = like(at, 1.0);
    const Real from = at - aside;
    const Real to = at + aside;
    const auto meets = both(both(open, from <= one), to >= -one);
    const auto first = both(meets, from < cut.from);
    return {select(first, from, cut.from), select(first, to, cut.to)};
}

/// An algebra asks and tells here about the switch at work. Whoever evaluates a graph provides it.
template <class Real>
class SwitchBoard {
public:
    using Mask = typename Enclosure<Real>::Mask;

    SwitchBoard() = default;
    SwitchBoard(const SwitchBoard&) = delete;
    SwitchBoard& operator=(const SwitchBoard&) = delete;
    virtual ~SwitchBoard() = default;

    /// Nothing: it is held nowhere.
    virtual std::optional<HeldAt<Real>> held(SwitchIndex index) = 0;
    /// Where it has two or three outcomes and is not held.
    virtual void report(SwitchIndex index, const Mask& two, const Mask& three) = 0;
    /// Where a kink may be.
    virtual void report_kink(const Mask& may_be) = 0;
    /// Whether report_cut is of use.
    [[nodiscard]] virtual bool wants_cuts() const { return false; }
    /// Where `open` holds, a switch that is not decided may change within `aside` of `at`, along
    /// the ray.
    virtual void report_cut(const Mask& /*open*/, const Real& /*at*/, const Real& /*aside*/) {}
};

/// The switch at work of an algebra, if there is one.
template <class Real>
class SwitchPort {
public:
    using Mask = typename Enclosure<Real>::Mask;

    SwitchPort() = default;
    explicit SwitchPort(SwitchBoard<Real>* board) : board_(board) {}

    void enter(SwitchIndex index) { index_ = index; }
    void report_kink(const Mask& may_be) const {
        if (board_ != nullptr) board_->report_kink(may_be);
    }
    [[nodiscard]] bool wants_cuts() const { return board_ != nullptr && board_->wants_cuts(); }
    void report_cut(const Mask& open, const Real& at, const Real& aside) const {
        board_->report_cut(open, at, aside);
    }
    /// The outcomes, whole numbers, where what is held is taken into account.
    [[nodiscard]] Interval<Real> outcomes(const Interval<Real>& all) const;

private:
    SwitchBoard<Real>* board_ = nullptr;
    SwitchIndex index_ = no_switch;
};

template <class Real>
Interval<Real> SwitchPort<Real>::outcomes(const Interval<Real>& all) const {
    if (board_ == nullptr || index_ == no_switch) return all;
    const auto number = [&](double value) { return like(all.hi, value); };
    const Real more = all.neg_lo + all.hi;
    const Mask two = more == number(1);
    const Mask three = more == number(2);
    const auto held = board_->held(index_);
    if (!held) {
        board_->report(index_, two, three);
        return all;
    }
    const Mask of_two = both(two, held->of_two);
    const Mask of_three = both(three, held->of_three);
    board_->report(index_, both(two, no(of_two)), both(three, no(of_three)));
    const Real one = held->outcome - all.neg_lo;
    return select(either(of_two, of_three), Interval<Real>{-one, one}, all);
}

}  // namespace zeroset
