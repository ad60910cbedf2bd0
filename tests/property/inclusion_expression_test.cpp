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

struct Boxes {
    std::array<std::array<Interval<float>, boxes>, variables - 1> x;
    Interval<float> w;
};

struct Ranges {
    std::array<Outcome<float>, boxes> of;
};

Boxes random_boxes(RandomNumbers& random) {
    Boxes result{};
    const bool usual = random.one_in(2);
    const auto draw = [&] {
        if (!usual) return random.interval<float>();
        const auto lo = static_cast<float>(random.uniform(-3, 3));
        const auto size = static_cast<float>(std::exp2(random.uniform(-20, 2)));
        return Interval<float>{-lo, lo + size};
    };
    for (auto& row : result.x) {
        for (Interval<float>& box : row)
            box = draw();
    }
    result.w = draw();
    return result;
}

Ranges ranges(const Kernel& kernel, const Boxes& in) {
    std::array<std::array<float, boxes>, variables - 1> neg_lo{};
    std::array<std::array<float, boxes>, variables - 1> hi{};
    for (std::size_t v = 0; v < variables - 1; ++v) {
        for (std::size_t i = 0; i < boxes; ++i) {
            neg_lo[v][i] = in.x[v][i].neg_lo;
            hi[v][i] = in.x[v][i].hi;
        }
    }
    const std::array<float, 2> uniforms{in.w.neg_lo, in.w.hi};
    std::array<float, boxes> f_neg_lo{};
    std::array<float, boxes> f_hi{};
    std::array<std::uint32_t, boxes> continuous{};
    kernel.range({boxes,
                  {neg_lo[0].data(), neg_lo[1].data(), neg_lo[2].data()},
                  {hi[0].data(), hi[1].data(), hi[2].data()},
                  uniforms.data(),
                  f_neg_lo.data(),
                  f_hi.data(),
                  continuous.data()});
    Ranges result{};
    for (std::size_t i = 0; i < boxes; ++i) {
        const bool somewhere = f_hi[i] != -std::numeric_limits<float>::infinity();
        const bool proved = continuous[i] != 0;
        result.of[i] = {{f_neg_lo[i], f_hi[i]}, somewhere, proved, proved};
    }
    return result;
}

class InclusionOfExpressions : public CountingTest {};

TEST_F(InclusionOfExpressions, OfRandomGraphsHolds) {
    RandomNumbers random(5);
    for (int formula = 0; formula < 8000 && !HasFailure(); ++formula) {
        const Expr expr = random_expression(random, 1 + formula % 6);
        const Boxes in = random_boxes(random);
        const Ranges out = in_tested_mode(ranges, interpret(expr), in);
        const Facts facts = facts_of(expr).back();
        for (std::size_t i = 0; i < boxes; ++i) {
            if (facts.nonnegative) {
                ASSERT_LE(out.of.at(i).value.neg_lo, 0) << "formula " << expr.canonical();
            }
            if (facts.undefined) {
                ASSERT_FALSE(out.of.at(i).somewhere) << "formula " << expr.canonical();
            }
            const std::array box{in.x[0][i], in.x[1][i], in.x[2][i], in.w};
            for (int k = 0; k < 3; ++k) {
                std::array<double, variables> at{};
                for (std::size_t v = 0; v < variables; ++v)
                    at.at(v) = random.point_in(box.at(v));
                ASSERT_TRUE(holds(out.of.at(i), reference(expr, at)))
                    << "formula " << expr.canonical() << "\n  x " << hex(box[0]) << "\n  y "
                    << hex(box[1]) << "\n  z " << hex(box[2]) << "\n  w " << hex(box[3])
                    << "\n  at (" << hex(at[0]) << ", " << hex(at[1]) << ", " << hex(at[2]) << ", "
                    << hex(at[3]) << ")";
            }
        }
    }
}

}  // namespace
}  // namespace zeroset::test
