#include "tests/property/operator_inclusion.hpp"

#include "engine/algebra/algebra.hpp"
#include "engine/real/block.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/sample_field.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

namespace zeroset::test {
namespace {

float enclosing(float /*kind*/, double value) { return float_above(value); }
double enclosing(double /*kind*/, double value) { return value; }

template <class Real>
Input<Real> constant_input(RandomNumbers& random) {
    const double lo =
        random.one_in(2) ? random.number<double>() : static_cast<double>(random.number<float>());
    const double hi = random.one_in(2) ? lo : std::nextafter(lo, infinity);
    const Facts facts{
        .nonnegative = lo >= 0, .uniform = true, .constant = Interval<double>{-lo, hi}};
    return {{enclosing(Real{}, -lo), enclosing(Real{}, hi)}, facts};
}

template <class Real>
Input<Real> nonnegative_input(RandomNumbers& random) {
    Facts facts;
    facts.nonnegative = true;
    return {absolute(random.interval<Real>()), facts};
}

/// A box with a gap inside it that holds no value.
template <class Real>
Input<Real> divided_input(RandomNumbers& random) {
    Input<Real> input{random.interval<Real>(), {}};
    const double a = random.point_in(input.box);
    const double b = random.point_in(input.box);
    input.gap = {enclosing(Real{}, -std::max(a, b)), enclosing(Real{}, std::min(a, b))};
    return input;
}

template <class Real>
Input<Real> any_input(RandomNumbers& random) {
    switch (random.below(6)) {
        case 0: return constant_input<Real>(random);
        case 1: return nonnegative_input<Real>(random);
        case 2: return divided_input<Real>(random);
        default: return {random.interval<Real>(), {}};
    }
}

template <class Real>
Input<Real> condition_input(RandomNumbers& random) {
    const int lo = random.between(0, 1);
    const int hi = random.between(lo, 1);
    Facts facts;
    facts.nonnegative = true;
    return {{-Real(lo), Real(hi)}, facts, true};
}

double first_lane(const Block<double>& block) {
    std::array<double, Block<double>::lanes> lanes{};
    std::memcpy(lanes.data(), &block, sizeof block);
    return lanes[0];
}

/// Whether a whole turn lies between the values of atan2 at a point and at its neighbour
/// (x, y_beyond).
bool turns(Op op, const Reference& here, double y, double y_beyond, double x) {
    if (op != Op::Atan2 || y == y_beyond) return false;
    const Reference there = reference(op, 0, MpfrNumber(y_beyond), MpfrNumber(x));
    if (!here.defined || !there.defined) return false;
    const MpfrNumber step = here.value - there.value;
    return step > 6.0 || step < -6.0;
}

bool is_step(const OpInfo& info) {
    return is_condition(info) || info.op == Op::Sign || info.op == Op::Floor ||
           info.op == Op::Ceil || info.op == Op::Round;
}

/// The continuous piece that holds the point (a, b): for a function with steps its value, for mod
/// floor(a/b), for others 0.
double piece(const OpInfo& info, const Reference& truth, double a, double b) {
    if (!truth.defined || truth.is_unknown()) return 0;
    if (is_step(info)) return truth.value.nearest();
    if (info.op != Op::Mod) return 0;
    const MpfrNumber quotient = (MpfrNumber(a) - truth.value) / MpfrNumber(b);
    return std::nearbyint(quotient.nearest());
}

}  // namespace

template <class Real>
double Input<Real>::point(RandomNumbers& random) const {
    if (condition) {
        return random.one_in(2) ? static_cast<double>(box.hi) : -static_cast<double>(box.neg_lo);
    }
    if (facts.constant) return random.point_in(*facts.constant);
    const double inside = random.point_in(box);
    if (!gap) return inside;
    const auto lower = static_cast<double>(gap->hi);
    const double upper = -static_cast<double>(gap->neg_lo);
    if (!(inside > lower && inside < upper)) return inside;
    return random.one_in(2) ? lower : upper;
}

template <class Real>
std::string Input<Real>::text() const {
    std::string text = hex(box);
    if (facts.constant) text += " (constant " + hex(*facts.constant) + ")";
    if (facts.nonnegative) text += " (known not to be negative)";
    if (gap) text += " (with sides " + hex(*gap) + ")";
    return text;
}

template <class Real>
Inputs<Real>::Inputs(const OpInfo& info, RandomNumbers& random) {
    for (int k = 0; k < 3; ++k) {
        of.at(static_cast<std::size_t>(k)) =
            takes_condition(info, k) ? condition_input<Real>(random) : any_input<Real>(random);
    }
}

template <class Real>
std::vector<std::array<double, 3>> Inputs<Real>::points(const OpInfo& info,
                                                        RandomNumbers& random) const {
    using Point = std::array<double, 3>;
    std::vector<Point> result;
    // Zeros of either sign differ, and a NaN is itself.
    const auto bits_of = [](const Point& point) {
        return std::bit_cast<std::array<std::uint64_t, 3>>(point);
    };
    for (int i = 0; i < points_a_box; ++i) {
        Point point{};
        for (std::size_t k = 0; k < static_cast<std::size_t>(info.arity); ++k)
            point.at(k) = of.at(k).point(random);
        const auto is_same = [&](const Point& other) { return bits_of(point) == bits_of(other); };
        if (std::ranges::none_of(result, is_same)) result.push_back(point);
    }
    return result;
}

template <class Real>
Outcome<Real> scalar_range(const Node& node, const Inputs<Real>& in) {
    const auto& [a, b, c] = in.of;
    const Enclosure<Real> x{a.box, {}, {}, {}, a.gap};
    const Enclosure<Real> y{b.box, {}, {}, {}, b.gap};
    const Enclosure<Real> z{c.box, {}, {}, {}, c.gap};
    IntervalAlgebra<Real> algebra;
    const Enclosure<Real> f =
        apply(algebra, node, Operand<Enclosure<Real>>{x, a.facts},
              Operand<Enclosure<Real>>{y, b.facts}, Operand<Enclosure<Real>>{z, c.facts});
    return {f.range, f.somewhere.value_or(true), f.everywhere.value_or(true),
            f.continuous.value_or(true), f.gap};
}

Outcome<double> block_range(const Node& node, const Inputs<double>& in) {
    using Lanes = Block<double>;
    const auto enclosure = [](const Input<double>& input) {
        const auto splat = [](const Interval<double>& box) {
            return Interval<Lanes>{Lanes::splat(box.neg_lo), Lanes::splat(box.hi)};
        };
        Enclosure<Lanes> result{splat(input.box)};
        if (input.gap) result.gap = splat(*input.gap);
        return result;
    };
    const auto& [a, b, c] = in.of;
    const auto x = enclosure(a);
    const auto y = enclosure(b);
    const auto z = enclosure(c);
    IntervalAlgebra<Lanes> algebra;
    const Enclosure<Lanes> f =
        apply(algebra, node, Operand<Enclosure<Lanes>>{x, a.facts},
              Operand<Enclosure<Lanes>>{y, b.facts}, Operand<Enclosure<Lanes>>{z, c.facts});
    const auto holds = [](const std::optional<BlockMask>& mask) {
        return !mask || (mask->bits & 1U) != 0;
    };
    const auto first = [](const Interval<Lanes>& box) {
        return Interval<double>{first_lane(box.neg_lo), first_lane(box.hi)};
    };
    Outcome<double> outcome{first(f.range), holds(f.somewhere), holds(f.everywhere),
                            holds(f.continuous)};
    if (f.gap) outcome.gap = first(*f.gap);
    return outcome;
}

Node random_operator_node(const OpInfo& info, RandomNumbers& random) {
    Node node = node_of(info.op);
    if (node.field) node.field = sample_fields()[random.below(sample_fields().size())];
    if (info.notation == Notation::Power) {
        node.number = random.one_in(9) ? 16 : random.between(2, 9);
    }
    if (info.notation == Notation::Wave) node.number = random.between(1, 20);
    if (info.notation == Notation::Root) {
        node.number = random.one_in(9) ? 101 : 2 * random.between(1, 4) + 1;
    }
    return node;
}

template <class Real>
void check_operator(OperatorRange<Real> range, const Node& node, const Inputs<Real>& in,
                    RandomNumbers& random, InclusionTally& tally) {
    const OpInfo& info = op_info(node.op);
    const auto& [a, b, c] = in.of;
    const Outcome<Real> outcome = in_tested_mode(range, node, in);
    std::optional<double> first_piece;
    for (const auto& [x, y, z] : in.points(info, random)) {
        const std::array<MpfrNumber, 3> point{MpfrNumber(x), MpfrNumber(y), MpfrNumber(z)};
        const Reference truth = node.field
                                    ? field_reference(*node.field, point[0], point[1], point[2])
                                    : reference(node.op, node.number, point[0], point[1], point[2]);
        const auto place = [&] {
            return "operator " + std::string(info.name) + ", number " +
                   std::to_string(node.number) + (node.field ? " of " + node.field->text() : "") +
                   "\n  a " + a.text() + "\n  b " + b.text() + "\n  c " + c.text() + "\n  at (" +
                   hex(x) + ", " + hex(y) + ", " + hex(z) + ")";
        };
        tally.note(complaint(outcome, truth, tally, node.op == Op::Angle), place);
        if (!outcome.continuous || !truth.defined) continue;
        const double beyond =
            std::max(std::nextafter(x, -infinity), -static_cast<double>(a.box.neg_lo));
        const double here = piece(info, truth, x, y);
        if (!first_piece) first_piece = here;
        if (turns(node.op, truth, x, beyond, y) || here != *first_piece) {
            tally.note("claimed continuous over a jump", place);
        }
    }
}

template struct Input<float>;
template struct Input<double>;
template struct Inputs<float>;
template struct Inputs<double>;
template Outcome<float> scalar_range(const Node&, const Inputs<float>&);
template Outcome<double> scalar_range(const Node&, const Inputs<double>&);
template void check_operator(OperatorRange<float>, const Node&, const Inputs<float>&,
                             RandomNumbers&, InclusionTally&);
template void check_operator(OperatorRange<double>, const Node&, const Inputs<double>&,
                             RandomNumbers&, InclusionTally&);

}  // namespace zeroset::test
