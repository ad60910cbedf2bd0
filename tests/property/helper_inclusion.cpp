#include "tests/property/helper_inclusion.hpp"

#include "tests/property/operator_inclusion.hpp"

#include <iterator>
#include <string>
#include <vector>

namespace zeroset::test {
namespace {

constexpr double factors[] = {1,    -1,    2,        -3,        0.5,     -0.375,      0x1.99999ap-4,
                              1e10, -1e10, 0x1p-100, -0x1p-140, 0x1p120, 0x1.fffffep0};

Reference power_at(const MpfrNumber& a, const MpfrNumber& b, int n) {
    return reference(Op::IntPower, n, a, b);
}
Reference product_at(const MpfrNumber& a, const MpfrNumber& b, int n) {
    return reference(Op::Multiply, n, a, b);
}

template <class Real>
std::vector<Helper<Real>> make_helpers() {
    using Box = Interval<Real>;
    using Range = Outcome<Real>;
    using Number = MpfrNumber;
    return {
        {"a * b", Domain::Any, [](const Box& a, const Box& b, const int&) { return Range{a * b}; },
         product_at},
        {"multiply_nonnegative_by", Domain::FirstNonnegative,
         [](const Box& a, const Box& b, const int&) {
             return Range{multiply_nonnegative_by(a, b)};
         },
         product_at},
        {"multiply_nonnegative", Domain::Nonnegative,
         [](const Box& a, const Box& b, const int&) { return Range{multiply_nonnegative(a, b)}; },
         product_at},
        {"scale", Domain::Any,
         [](const Box& a, const Box&, const int& n) { return Range{scale(a, factors[n])}; },
         [](const Number& a, const Number&, int n) {
             return product_at(a, Number(factors[n]), 0);
         }},
        {"square_nonnegative", Domain::Nonnegative,
         [](const Box& a, const Box&, const int&) { return Range{square_nonnegative(a)}; },
         [](const Number& a, const Number& b, int) { return power_at(a, b, 2); }},
        {"power_nonnegative", Domain::Nonnegative,
         [](const Box& a, const Box&, const int& n) { return Range{power_nonnegative(a, n + 1)}; },
         [](const Number& a, const Number& b, int n) { return power_at(a, b, n + 1); }},
        {"power", Domain::Any,
         [](const Box& a, const Box&, const int& n) { return Range{power(a, n + 1, false)}; },
         [](const Number& a, const Number& b, int n) { return power_at(a, b, n + 1); }},
        {"power of 16", Domain::Any,
         [](const Box& a, const Box&, const int&) { return Range{power(a, 16, false)}; },
         [](const Number& a, const Number& b, int) { return power_at(a, b, 16); }},
        {"absolute", Domain::Any,
         [](const Box& a, const Box&, const int&) { return Range{absolute(a)}; },
         [](const Number& a, const Number& b, int n) { return reference(Op::Abs, n, a, b); }},
        {"square_root", Domain::Nonnegative,
         [](const Box& a, const Box&, const int&) { return Range{square_root(a)}; },
         [](const Number& a, const Number& b, int n) { return reference(Op::Sqrt, n, a, b); }},
    };
}

}  // namespace

template <class Real>
std::span<const Helper<Real>> helpers() {
    static const std::vector<Helper<Real>> all = make_helpers<Real>();
    return all;
}

template <class Real>
void check_helper(const Helper<Real>& helper, RandomNumbers& random, InclusionTally& tally) {
    auto a = random.interval<Real>();
    auto b = random.interval<Real>();
    if (helper.domain != Domain::Any) a = absolute(a);
    if (helper.domain == Domain::Nonnegative) b = absolute(b);
    const int n = random.between(0, static_cast<int>(std::size(factors)) - 1);
    const Outcome<Real> outcome = in_tested_mode(helper.range, a, b, n);
    for (int k = 0; k < points_a_box; ++k) {
        const double x = random.point_in(a);
        const double y = random.point_in(b);
        const Reference truth = helper.truth(MpfrNumber(x), MpfrNumber(y), n);
        tally.note(complaint(outcome, truth, tally), [&] {
            return "function " + std::string(helper.name) + ", n " + std::to_string(n) + "\n  a " +
                   hex(a) + "\n  b " + hex(b) + "\n  at (" + hex(x) + ", " + hex(y) + ")";
        });
    }
}

template std::span<const Helper<float>> helpers();
template std::span<const Helper<double>> helpers();
template void check_helper(const Helper<float>&, RandomNumbers&, InclusionTally&);
template void check_helper(const Helper<double>&, RandomNumbers&, InclusionTally&);

}  // namespace zeroset::test
