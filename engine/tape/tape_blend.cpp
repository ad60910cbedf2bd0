#include "engine/tape/tape_marks.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

using Index = Tape::Index;
using Step = Tape::Step;

class Finder {
public:
    explicit Finder(const Tape& tape) : tape_(tape) {}

    std::optional<Blend> find(const Step& sum);

private:
    [[nodiscard]] const Step& step(Index i) const { return tape_.steps()[i]; }
    [[nodiscard]] const Step& operand(const Step& of, std::size_t k) const {
        return step(of.operands[k]);
    }
    [[nodiscard]] bool is(const Step& what, Op op) const {
        return !tape_.graph()->is_first(what.node) && tape_.node(what).op == op;
    }
    /// The interval of a constant above 0.
    [[nodiscard]] std::optional<Interval<double>> positive(const Step& what) const {
        const auto& box = tape_.facts(what).constant;
        return box && box->neg_lo < 0 ? box : std::nullopt;
    }
    [[nodiscard]] bool is_zero(const Step& what) const {
        const Facts& facts = tape_.facts(what);
        return facts.exact() && facts.constant->hi == 0;
    }
    /// An upper bound of q, which step i computes.
    std::optional<double> bound_of(Index i);
    /// The upper bound of max(k - |a - b|, 0), which is k.
    std::optional<double> bound_of_hat(Index i);

    const Tape& tape_;
    Index hat_ = Tape::no_choice;
    std::array<Index, 2> between_{};  ///< a and b
    double width_ = 0;                ///< k
};

std::optional<double> Finder::bound_of_hat(Index i) {
    const Step& hat = step(i);
    const std::size_t zero = is_zero(operand(hat, 0)) ? 0 : 1;
    const Step& height = operand(hat, 1 - zero);
    if (!is_zero(operand(hat, zero)) || !is(height, Op::Subtract)) return std::nullopt;
    const auto k = positive(operand(height, 0));
    const Step& distance = operand(height, 1);
    if (!k || !is(distance, Op::Abs) || !is(operand(distance, 0), Op::Subtract)) {
        return std::nullopt;
    }
    const Step& difference = operand(distance, 0);
    between_ = {difference.operands[0], difference.operands[1]};
    hat_ = i;
    width_ = k->hi;
    return width_;
}

std::optional<double> Finder::bound_of(Index i) {
    const Step& q = step(i);
    if (is(q, Op::Max)) return bound_of_hat(i);
    if (is(q, Op::IntPower)) {
        const int n = tape_.node(q).number;
        const auto bound = bound_of(q.operands[0]);
        return n > 0 && bound ? std::optional(std::pow(*bound, n)) : std::nullopt;
    }
    if (is(q, Op::Divide)) {
        const auto divisor = positive(operand(q, 1));
        const auto bound = divisor ? bound_of(q.operands[0]) : std::nullopt;
        return bound ? std::optional(*bound / -divisor->neg_lo) : std::nullopt;
    }
    if (!is(q, Op::Multiply)) return std::nullopt;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        const auto factor = positive(operand(q, k));
        const auto bound = factor ? bound_of(q.operands[1 - k]) : std::nullopt;
        if (bound) return *bound * factor->hi;
    }
    if (q.operands[0] != q.operands[1]) return std::nullopt;
    const auto bound = bound_of(q.operands[0]);
    return bound ? std::optional(*bound * *bound) : std::nullopt;
}

std::optional<Blend> Finder::find(const Step& sum) {
    const Op wanted = tape_.node(sum).op == Op::Add ? Op::Max : Op::Min;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        const Step& extreme = operand(sum, k);
        if (!is(extreme, wanted)) continue;
        const auto bound = bound_of(sum.operands[1 - k]);
        if (!bound || hat_ == sum.operands[k]) continue;
        const std::array of{extreme.operands[0], extreme.operands[1]};
        if (between_ != of && std::array{between_[1], between_[0]} != of) continue;
        const double reach = (width_ + *bound) * (1.0 + 0x1p-20);
        if (std::isfinite(reach))
            return Blend{.extreme = sum.operands[k], .hat = hat_, .height = width_, .reach = reach};
    }
    return std::nullopt;
}

}  // namespace

std::optional<Blend> blend_of(const Tape& tape, const Tape::Step& sum) {
    return Finder(tape).find(sum);
}

}  // namespace zeroset
