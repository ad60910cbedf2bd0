#include "engine/expr/facts.hpp"
#include "engine/expr/interpret.hpp"
#include "tests/support/inclusion.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

// Whole formulas: the range kernel encloses f over a box at every real point of the box.

namespace zeroset::test {
namespace {

constexpr std::size_t boxes = batch_multiple;
constexpr std::size_t variables = 4;

template <class Real>
struct Boxes {
    std::array<std::array<Interval<Real>, boxes>, variables - 1> x;
    Interval<Real> w;
};

template <class Real>
struct Ranges {
    std::array<Outcome<Real>, boxes> of;
};

template <class Real>
Boxes<Real> random_boxes(RandomNumbers& random) {
    const double smallest = sizeof(Real) == 4 ? -20 : -48;
    Boxes<Real> result{};
    const bool usual = random.one_in(2);
    const auto draw = [&] {
        if (!usual) return random.interval<Real>();
        const auto lo = static_cast<Real>(random.uniform(-3, 3));
        const auto size = static_cast<Real>(std::exp2(random.uniform(smallest, 2)));
        return Interval<Real>{-lo, lo + size};
    };
    for (auto& row : result.x) {
        for (Interval<Real>& box : row)
            box = draw();
    }
    result.w = draw();
    return result;
}

/// Past the kernel's own check of the mode, which the mutant fails.
void run(const Kernel& kernel, const RangeBatch& batch) {
    kernel.range_float.call(kernel.range_float.code.get(), &batch);
}
void run(const Kernel& kernel, const RangeBatchOf<double>& batch) {
    kernel.range_double.call(kernel.range_double.code.get(), &batch);
}

template <class Real>
Ranges<Real> ranges(const Kernel& kernel, const Boxes<Real>& in) {
    std::array<std::array<Real, boxes>, variables - 1> neg_lo{};
    std::array<std::array<Real, boxes>, variables - 1> hi{};
    for (std::size_t v = 0; v < variables - 1; ++v) {
        for (std::size_t i = 0; i < boxes; ++i) {
            neg_lo[v][i] = in.x[v][i].neg_lo;
            hi[v][i] = in.x[v][i].hi;
        }
    }
    const std::array<Real, 2> uniforms{in.w.neg_lo, in.w.hi};
    std::array<Real, boxes> f_neg_lo{};
    std::array<Real, boxes> f_hi{};
    std::array<ContinuityMask<Real>, boxes> continuous{};
    run(kernel, RangeBatchOf<Real>{boxes,
                                   {neg_lo[0].data(), neg_lo[1].data(), neg_lo[2].data()},
                                   {hi[0].data(), hi[1].data(), hi[2].data()},
                                   uniforms.data(),
                                   f_neg_lo.data(),
                                   f_hi.data(),
                                   continuous.data()});
    Ranges<Real> result{};
    for (std::size_t i = 0; i < boxes; ++i) {
        const bool somewhere = f_hi[i] != -std::numeric_limits<Real>::infinity();
        const bool proved = continuous[i] != 0;
        result.of[i] = {{f_neg_lo[i], f_hi[i]}, somewhere, proved, proved};
    }
    return result;
}

class InclusionOfExpressions : public CountingTest {
protected:
    template <class Real>
    static void enclose_random_graphs(int formulas, std::uint64_t seed) {
        RandomNumbers random(seed);
        for (int formula = 0; formula < formulas && !HasFailure(); ++formula) {
            const Expr expr = random_expression(random, 1 + formula % 6);
            const Boxes in = random_boxes<Real>(random);
            const Ranges out = in_tested_mode(ranges<Real>, interpret(expr), in);
            for (std::size_t i = 0; i < boxes && !HasFailure(); ++i) {
                expect_facts(expr, out.of.at(i));
                const std::array box{in.x[0][i], in.x[1][i], in.x[2][i], in.w};
                for (int k = 0; k < 3 && !HasFailure(); ++k)
                    expect_enclosed(expr, box, out.of.at(i), random);
            }
        }
    }

private:
    template <class Real>
    static void expect_facts(const Expr& expr, const Outcome<Real>& outcome) {
        const Facts facts = facts_of(expr).back();
        if (facts.nonnegative) {
            ASSERT_LE(outcome.value.neg_lo, 0) << "formula " << expr.canonical();
        }
        if (facts.undefined) {
            ASSERT_FALSE(outcome.somewhere) << "formula " << expr.canonical();
        }
    }

    template <class Real>
    static void expect_enclosed(const Expr& expr, const std::array<Interval<Real>, variables>& box,
                                const Outcome<Real>& outcome, RandomNumbers& random) {
        std::array<double, variables> at{};
        for (std::size_t v = 0; v < variables; ++v)
            at.at(v) = random.point_in(box.at(v));
        ASSERT_TRUE(holds(outcome, reference(expr, at)))
            << "formula " << expr.canonical() << "\n  x " << hex(box[0]) << "\n  y " << hex(box[1])
            << "\n  z " << hex(box[2]) << "\n  w " << hex(box[3]) << "\n  at (" << hex(at[0])
            << ", " << hex(at[1]) << ", " << hex(at[2]) << ", " << hex(at[3]) << ")";
    }
};

TEST_F(InclusionOfExpressions, OfRandomGraphsInFloatHolds) {
    enclose_random_graphs<float>(8000, 5);
}
TEST_F(InclusionOfExpressions, OfRandomGraphsInDoubleHolds) {
    enclose_random_graphs<double>(8000, 7);
}

}  // namespace
}  // namespace zeroset::test
