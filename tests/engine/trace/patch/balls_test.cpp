// Balls and 2 x 2 matrices of them against exact arithmetic, with each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/engine/trace/patch/balls_test.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/real/rounding.hpp"
#include "engine/trace/patch/balls-inl.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/only_target.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#ifndef ZEROSET_BALLS_TEST_SHARED
#define ZEROSET_BALLS_TEST_SHARED
namespace zeroset::test::balls_test {

constexpr std::size_t most_lanes = 16;
using Lanes = std::array<double, most_lanes>;
using BallLanes = RealBall<Lanes>;

/// Operands and results of operations; a problem in each lane.
struct Problems {
    BallLanes a, b;
    Matrix2<Lanes> m;
    Vector2<BallLanes> g;

    BallLanes less_product;
    Vector2<Lanes> rest;  ///< of the rows of I - m (a, b; g)
    Vector2<BallLanes> image, zeros;
    Lanes zeros_known;
    Lanes zeros_lost;
};

}  // namespace zeroset::test::balls_test
#endif

HWY_BEFORE_NAMESPACE();
namespace zeroset::test::balls_test::HWY_NAMESPACE {

using namespace zeroset::HWY_NAMESPACE;
using zeroset::HWY_NAMESPACE::operator*;

/// A carrier's numbers from and to lanes.
template <class Real>
Real load(const Lanes& from) {
    if constexpr (std::is_floating_point_v<Real>) {
        return static_cast<Real>(from[0]);
    } else {
        using Number = hn::TFromV<Real>;
        std::array<Number, most_lanes> numbers{};
        for (std::size_t i = 0; i < most_lanes; ++i)
            numbers[i] = static_cast<Number>(from[i]);
        return hn::LoadU(hn::DFromV<Real>(), numbers.data());
    }
}
template <class Real>
RealBall<Real> load(const BallLanes& from) {
    return {load<Real>(from.middle), load<Real>(from.radius)};
}
template <class Real>
void store(Real from, Lanes& to) {
    if constexpr (std::is_floating_point_v<Real>) {
        to[0] = from;
    } else {
        std::array<hn::TFromV<Real>, most_lanes> numbers{};
        hn::StoreU(from, hn::DFromV<Real>(), numbers.data());
        for (std::size_t i = 0; i < most_lanes; ++i)
            to[i] = numbers[i];
    }
}
template <class Real>
void store(const RealBall<Real>& from, BallLanes& to) {
    store(from.middle, to.middle);
    store(from.radius, to.radius);
}
template <class Real>
void store(const Vector2<RealBall<Real>>& from, Vector2<BallLanes>& to) {
    store(from.p, to.p);
    store(from.q, to.q);
}

template <class Real>
void solve(Problems& of) {
    const auto a = load<Real>(of.a);
    const auto b = load<Real>(of.b);
    const Matrix2<Real> m{.pp = load<Real>(of.m.pp),
                          .pq = load<Real>(of.m.pq),
                          .qp = load<Real>(of.m.qp),
                          .qq = load<Real>(of.m.qq)};
    const Vector2<RealBall<Real>> g{.p = load<Real>(of.g.p), .q = load<Real>(of.g.q)};
    store(less_product(a, b, g.p), of.less_product);
    const Vector2<Real> rest =
        rest_of_product(m, Matrix2<RealBall<Real>>{.pp = a, .pq = b, .qp = g.p, .qq = g.q});
    store(rest.p, of.rest.p);
    store(rest.q, of.rest.q);
    store(m * g, of.image);
    const Zeros2<Real> zeros = zeros_of(divisor_of(m), g);
    store(zeros.x, of.zeros);
    store(zeros.lost, of.zeros_lost);
    if constexpr (std::is_floating_point_v<Real>) {
        of.zeros_known[0] = zeros.known ? 1.0 : 0.0;
    } else {
        store(hn::IfThenElseZero(zeros.known, like(zeros.lost, 1.0)), of.zeros_known);
    }
}

void solve_in_double(Problems& of) { solve<hn::Vec<hn::CappedTag<double, 8>>>(of); }
void solve_in_float(Problems& of) { solve<hn::Vec<hn::CappedTag<float, 16>>>(of); }
void solve_one_in_double(Problems& of) { solve<double>(of); }
void solve_one_in_float(Problems& of) { solve<float>(of); }
std::size_t lanes_in_double() { return hn::MaxLanes(hn::CappedTag<double, 8>()); }
std::size_t lanes_in_float() { return hn::MaxLanes(hn::CappedTag<float, 16>()); }

}  // namespace zeroset::test::balls_test::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset::test::balls_test {
namespace {

HWY_EXPORT(solve_in_double);
HWY_EXPORT(solve_in_float);
HWY_EXPORT(solve_one_in_double);
HWY_EXPORT(solve_one_in_float);
HWY_EXPORT(lanes_in_double);
HWY_EXPORT(lanes_in_float);

/// Where a ball begins to say nothing.
template <class Number>
constexpr double most = sizeof(Number) == sizeof(float) ? 0x1p100 : 0x1p970;

/// Whether a number is within a ball, as far as the ball is known.
template <class Number>
bool holds(const BallLanes& ball, std::size_t lane, const MpfrNumber& number) {
    const double middle = ball.middle[lane];
    const double radius = ball.radius[lane];
    if (!(std::abs(middle) < most<Number> && radius < most<Number>)) return true;
    const MpfrNumber off = number - MpfrNumber(middle);
    return !((off - MpfrNumber(radius)) > 0.0) && !((off + MpfrNumber(radius)) < 0.0);
}

/// Matrices and balls that are likely to find faults.
template <class Number>
class RandomProblems {
public:
    explicit RandomProblems(std::uint64_t seed) : random_(seed) {}

    Problems next() {
        Problems all{};
        for (Lanes* const of : {&all.a.middle, &all.b.middle, &all.g.p.middle, &all.g.q.middle,
                                &all.m.pp, &all.m.pq, &all.m.qp, &all.m.qq}) {
            for (double& number : *of)
                number = any();
        }
        for (Lanes* const of : {&all.a.radius, &all.b.radius, &all.g.p.radius, &all.g.q.radius}) {
            for (double& number : *of)
                number = random_.one_in(3) ? 0.0 : std::abs(any());
        }
        // Many matrices are nearly singular.
        for (std::size_t i = 0; i < most_lanes; ++i) {
            if (random_.one_in(2)) continue;
            const Number factor = random_.template number<Number>();
            all.m.qp[i] = random_.nudged(static_cast<Number>(all.m.pp[i]) * factor);
            all.m.qq[i] = random_.nudged(static_cast<Number>(all.m.pq[i]) * factor);
        }
        return all;
    }
    /// A number of a ball.
    MpfrNumber number_in(const BallLanes& ball, std::size_t lane) {
        const double share = random_.one_in(2)   ? random_.uniform(-1.0, 1.0)
                             : random_.one_in(2) ? 1.0
                                                 : -1.0;
        return MpfrNumber(ball.middle[lane]) + MpfrNumber(share) * MpfrNumber(ball.radius[lane]);
    }

private:
    double any() {
        const double special[] = {
            std::numeric_limits<Number>::infinity(), -std::numeric_limits<Number>::infinity(),
            std::numeric_limits<Number>::quiet_NaN(), std::numeric_limits<Number>::max(),
            std::numeric_limits<Number>::min()};
        if (random_.one_in(60)) return special[random_.below(std::size(special))];
        return static_cast<double>(random_.template number<Number>());
    }

    RandomNumbers random_;
};

/// Whether what goes into an operation is known, as its contract asks.
template <class Number>
bool is_known(const BallLanes& ball, std::size_t lane) {
    return std::abs(ball.middle[lane]) < most<Number> && ball.radius[lane] < most<Number>;
}
bool is_finite(const Matrix2<Lanes>& m, std::size_t lane) {
    return std::isfinite(m.pp[lane]) && std::isfinite(m.pq[lane]) && std::isfinite(m.qp[lane]) &&
           std::isfinite(m.qq[lane]);
}

/// How many zeros were known: the rest tests nothing.
template <class Number>
std::size_t check(const Problems& of, std::size_t lane, RandomProblems<Number>& random) {
    const auto number = [](const Lanes& from, std::size_t i) { return MpfrNumber(from[i]); };
    if (is_known<Number>(of.a, lane) && is_known<Number>(of.b, lane)) {
        const MpfrNumber a = random.number_in(of.a, lane);
        const MpfrNumber b = random.number_in(of.b, lane);
        if (is_known<Number>(of.g.p, lane)) {
            EXPECT_TRUE(
                holds<Number>(of.less_product, lane, random.number_in(of.g.p, lane) - a * b));
        }
    }
    if (!is_known<Number>(of.g.p, lane) || !is_known<Number>(of.g.q, lane)) return 0;
    if (!is_finite(of.m, lane)) return 0;
    const MpfrNumber g1 = random.number_in(of.g.p, lane);
    const MpfrNumber g2 = random.number_in(of.g.q, lane);
    const MpfrNumber pp = number(of.m.pp, lane);
    const MpfrNumber pq = number(of.m.pq, lane);
    const MpfrNumber qp = number(of.m.qp, lane);
    const MpfrNumber qq = number(of.m.qq, lane);
    if (is_known<Number>(of.a, lane) && is_known<Number>(of.b, lane)) {
        const MpfrNumber a = random.number_in(of.a, lane);
        const MpfrNumber b = random.number_in(of.b, lane);
        const MpfrNumber one(1.0);
        const auto sum = [](const MpfrNumber& x, const MpfrNumber& y) {
            return (x.sign() < 0 ? -x : x) + (y.sign() < 0 ? -y : y);
        };
        const auto is_bound = [](double bound, const MpfrNumber& of_row) {
            return !(bound < most<Number>) || !(of_row > bound);
        };
        EXPECT_TRUE(is_bound(of.rest.p[lane], sum(pp * a + pq * g1 - one, pp * b + pq * g2)));
        EXPECT_TRUE(is_bound(of.rest.q[lane], sum(qp * a + qq * g1, qp * b + qq * g2 - one)));
    }
    EXPECT_TRUE(holds<Number>(of.image.p, lane, pp * g1 + pq * g2));
    EXPECT_TRUE(holds<Number>(of.image.q, lane, qp * g1 + qq * g2));
    if (of.zeros_known[lane] == 0.0) return 0;
    const MpfrNumber determinant = pp * qq - pq * qp;
    EXPECT_NE(determinant.sign(), 0);
    EXPECT_TRUE(holds<Number>(of.zeros.p, lane, (pq * g2 - qq * g1) / determinant));
    EXPECT_TRUE(holds<Number>(of.zeros.q, lane, (qp * g1 - pp * g2) / determinant));
    // For the middles alone the part by rounding is enough.
    const MpfrNumber m1 = number(of.g.p.middle, lane);
    const MpfrNumber m2 = number(of.g.q.middle, lane);
    const BallLanes p{of.zeros.p.middle, of.zeros_lost};
    const BallLanes q{of.zeros.q.middle, of.zeros_lost};
    EXPECT_TRUE(holds<Number>(p, lane, (pq * m2 - qq * m1) / determinant));
    EXPECT_TRUE(holds<Number>(q, lane, (qp * m1 - pp * m2) / determinant));
    return 1;
}

Problems solved(Problems problems, void (*solve)(Problems&)) {
    const RoundingGuard<FE_UPWARD> upward;
    solve(problems);
    return problems;
}

template <class Number>
void check_all(std::uint64_t seed, std::size_t lanes, void (*solve)(Problems&)) {
    RandomProblems<Number> random(seed);
    std::size_t known = 0;
    const std::size_t rounds = 10000 / lanes;
    for (std::size_t i = 0; i < rounds; ++i) {
        const Problems problems = solved(random.next(), solve);
        for (std::size_t lane = 0; lane < lanes; ++lane)
            known += check<Number>(problems, lane, random);
        ASSERT_FALSE(testing::Test::HasFailure()) << "round " << i;
    }
    EXPECT_GT(known, rounds * lanes / 4);
}

TEST(Balls, HoldExactResultsWithEachInstructionSet) {
    std::uint64_t seed = 1;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        const OnlyTarget only(target);
        check_all<double>(seed++, HWY_DYNAMIC_DISPATCH(lanes_in_double)(),
                          HWY_DYNAMIC_DISPATCH(solve_in_double));
        check_all<float>(seed++, HWY_DYNAMIC_DISPATCH(lanes_in_float)(),
                         HWY_DYNAMIC_DISPATCH(solve_in_float));
        check_all<double>(seed++, 1, HWY_DYNAMIC_DISPATCH(solve_one_in_double));
        check_all<float>(seed++, 1, HWY_DYNAMIC_DISPATCH(solve_one_in_float));
    }
}

TEST(Balls, SayNothingOfWhatIsUnknown) {
    const double unknown[] = {std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()};
    for (const double number : unknown) {
        Problems problems{};
        problems.a = {.middle = {1.0}, .radius = {number}};
        problems.b = {.middle = {1.0}, .radius = {0.0}};
        problems.m = {.pp = {1.0}, .pq = {2.0}, .qp = {3.0}, .qq = {4.0}};
        problems.g = {.p = {.middle = {number}, .radius = {0.0}}, .q = problems.b};
        problems = solved(problems, HWY_DYNAMIC_DISPATCH(solve_one_in_double));
        EXPECT_FALSE(problems.rest.p[0] < 1.0);
        EXPECT_FALSE(is_known<double>(problems.less_product, 0));
        EXPECT_FALSE(is_known<double>(problems.image.p, 0));
        EXPECT_FALSE(is_known<double>(problems.image.q, 0));
        EXPECT_EQ(problems.zeros_known[0], 0.0);
    }
}

}  // namespace
}  // namespace zeroset::test::balls_test

#endif
