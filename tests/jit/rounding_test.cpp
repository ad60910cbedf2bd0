#include "engine/real/rounding.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "jit/compile.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/real_types.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

// Machine code rounds upward before and after its calls, and never rejects a box of which nothing
// is known.

namespace zeroset::test::rounding_test {
namespace {

template <class Real>
class JitRounding : public ::testing::Test {
protected:
    using Boxes = std::array<Interval<Real>, 3>;

    /// Returns the range over the box, which is the same in all lanes.
    static Interval<Real> range(const Kernel& kernel, const Boxes& box) {
        std::array<std::vector<Real>, 3> neg_lo;
        std::array<std::vector<Real>, 3> hi;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            neg_lo.at(axis).assign(batch_multiple, box.at(axis).neg_lo);
            hi.at(axis).assign(batch_multiple, box.at(axis).hi);
        }
        std::vector<Real> f_neg_lo(batch_multiple);
        std::vector<Real> f_hi(batch_multiple);
        std::vector<ContinuityMask<Real>> continuous(batch_multiple);
        Uniforms uniforms;
        uniforms.set(0, 0.5);
        const UpwardRounding upward;
        kernel.range(RangeBatchOf<Real>{batch_multiple,
                                        {neg_lo[0].data(), neg_lo[1].data(), neg_lo[2].data()},
                                        {hi[0].data(), hi[1].data(), hi[2].data()},
                                        uniforms.boxes<Real>(),
                                        f_neg_lo.data(),
                                        f_hi.data(),
                                        continuous.data()});
        return {f_neg_lo.back(), f_hi.back()};
    }

    /// Returns kernels of a graph: the interpreter's, and machine code of the widest registers, in
    /// a long run of each width.
    static std::vector<Kernel> kernels(const Expr& expr) {
        std::vector<Kernel> all{interpret(expr)};
        for (int lanes = is_long_run() ? 4 : jit::host_lanes(); lanes <= jit::host_lanes();
             lanes *= 2)
            all.push_back(*jit::compile(expr, {.lanes = lanes, .with_double = true}));
        return all;
    }

    /// True if the range excludes 0, so that a tracer may skip the box.
    static bool is_rejected(const Interval<Real>& f) { return f.neg_lo < 0 || f.hi < 0; }
};
TYPED_TEST_SUITE(JitRounding, RealTypes, RealTypeNames);

TYPED_TEST(JitRounding, IsUpwardBesideCalls) {
    const bool is_float = sizeof(TypeParam) == 4;
    const auto neg_lo = static_cast<TypeParam>(is_float ? -0x1.555554p-2 : -0x1.5555555555555p-2);
    const auto hi = static_cast<TypeParam>(is_float ? 0x1.555556p-2 : 0x1.5555555555556p-2);
    for (const char* const function :
         {"sin(z)", "cos(z)", "exp(z)", "ln(z)", "atan(z)", "cbrt(z)", "tanh(z)", "atan2(z, y)"}) {
        const std::string call(function);
        std::vector<std::string> texts{"min(x/y, 9 + " + call + ")", "min(9 + " + call + ", x/y)",
                                       "max(x/y, " + call + " - 9)"};
        if (!is_long_run()) texts = {texts[call.size() % 3]};
        for (const std::string& text : texts) {
            for (const Kernel& kernel : TestFixture::kernels(*parse(text))) {
                const auto found = TestFixture::range(
                    kernel, {point(TypeParam(1)), point(TypeParam(3)), point(TypeParam(0.5))});
                EXPECT_EQ(found.neg_lo, neg_lo) << text;
                EXPECT_EQ(found.hi, hi) << text;
            }
        }
    }
}

TYPED_TEST(JitRounding, RejectsNoUnknownBoxOfAnOperator) {
    const TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
    for (const OpInfo& info : operators()) {
        for (const Kernel& kernel : TestFixture::kernels(operator_on_variables(info))) {
            const auto unknown = TestFixture::range(kernel, {{{nan, nan}, {nan, nan}, {nan, nan}}});
            const auto whole =
                TestFixture::range(kernel, {whole_line(nan), whole_line(nan), whole_line(nan)});
            EXPECT_TRUE(!TestFixture::is_rejected(unknown) || TestFixture::is_rejected(whole))
                << info.name << ": [" << -unknown.neg_lo << ", " << unknown.hi << "]";
        }
    }
}

TYPED_TEST(JitRounding, RejectsNoUnknownBoxOfRandomFormulas) {
    const TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
    RandomNumbers random(21);
    for (int i = 0; i < (is_long_run() ? 300 : 100); ++i) {
        const Expr expr = random_expression(random, 1 + i % 6);
        // Machine code gives the interpreter's bits, so compiling every tenth expression is enough.
        const auto kernels =
            i % 10 == 0 ? TestFixture::kernels(expr) : std::vector<Kernel>{interpret(expr)};
        auto unknown = std::array{random.interval<TypeParam>(), random.interval<TypeParam>(),
                                  random.interval<TypeParam>()};
        auto whole = unknown;
        const std::size_t axis = random.below(3);
        unknown.at(axis) = {nan, nan};
        whole.at(axis) = whole_line(nan);
        for (const Kernel& kernel : kernels) {
            const auto found = TestFixture::range(kernel, unknown);
            EXPECT_TRUE(!TestFixture::is_rejected(found) ||
                        TestFixture::is_rejected(TestFixture::range(kernel, whole)))
                << expr.canonical() << ": [" << -found.neg_lo << ", " << found.hi << "]";
        }
    }
}

}  // namespace
}  // namespace zeroset::test::rounding_test
