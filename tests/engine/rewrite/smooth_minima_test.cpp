#include "engine/language/parse.hpp"
#include "engine/rewrite/passes.hpp"
#include "tests/support/mpfr_number.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace zeroset::smooth_minima_test {
namespace {

std::size_t count_of(const Expr& f, Op op) {
    return static_cast<std::size_t>(
        std::ranges::count_if(f.nodes(), [op](const Node& node) { return node.op == op; }));
}

/// The ways in which shaders and this program's own functions write them.
std::string with_ramp(const std::string& text, const std::string& ramp) {
    std::string result;
    for (const char c : text)
        result += c == 'h' ? "clamp(" + ramp + ", 0, 1)" : std::string(1, c);
    return result;
}

void expect_same(const std::string& text, std::size_t minima) {
    const Expr f = *parse(text);
    const Expr smooth = with_smooth_minima(f);
    EXPECT_EQ(count_of(smooth, Op::SmoothMin), minima) << text << " is " << smooth.canonical();
    EXPECT_EQ(count_of(smooth, Op::Min) + count_of(smooth, Op::Max), 0U) << smooth.canonical();
    for (double x = -1.5; x < 1.5; x += 0.07) {
        const std::array<double, 4> at{x, 0.4 - x * x, 0.3 * x, 0.1};
        const test::MpfrNumber error =
            test::reference(f, at).value - test::reference(smooth, at).value;
        EXPECT_LT(std::abs(error.nearest()), 1e-15) << text << " at " << x;
    }
}

TEST(WithSmoothMinima, OwnFunctionsAndTheirChains) {
    expect_same("smin(x, y, 1)", 1);
    expect_same("smin(x, y, 0.3)", 1);
    expect_same("smax(x, smax(y, z, 1/4), 0.25)", 2);
    expect_same("smooth_union(x, 2y - 0.1, z, 0.1)", 2);
    expect_same("smooth_subtract(x, y, z, w, 0.3)", 3);
    expect_same("smooth_intersect(x, y, z, 2)", 2);
    expect_same("smin(smax(x, y, 1/3), -smin(z, x y, 0.7), 0.2)", 3);
}

TEST(WithSmoothMinima, HatsWrittenByHand) {
    expect_same("min(x, y) - max(0.2 - abs(y - x), 0)^2/0.8", 1);
    expect_same("max(x, y) + max(0.2 - abs(y - x), 0)^2/0.8", 1);
    expect_same("min(x, y) - (max(0.1 - abs(x - y), 0)/0.1)^2*0.1*(1/4)", 1);
    expect_same("max(0, 0.5 - abs(x - y))^2*0.5 - min(y, x)", 1);
}

TEST(WithSmoothMinima, MixesOfShaders) {
    for (const char* mix : {"mix(y, x, h)", "(y*(1 - h) + x*h)", "(y + (x - y)*h)"}) {
        const std::string m = mix;
        expect_same(with_ramp(m + " - 0.3*h*(1 - h)", "0.5 + 0.5*(y - x)/0.3"), 1);
        expect_same(with_ramp(m + " + 0.3*h*(1 - h)", "0.5 - 0.5*(y - x)/0.3"), 1);
        expect_same(with_ramp(m + " + 0.3*h*(1 - h)", "0.5 + (x - y)*5/3"), 1);
    }
    expect_same(with_ramp("mix(y, -x, h) + 0.1*h*(1 - h)", "0.5 - 0.5*(y + x)/0.1"), 1);
}

/// Another width or another sign is another function.
TEST(WithSmoothMinima, OthersStay) {
    for (const char* text :
         {"min(x, y) - max(0.2 - abs(y - x), 0)^2/0.9",
          "min(x, y) - max(0.2 - abs(y - z), 0)^2/0.8",
          "min(x, y) + max(0.2 - abs(y - x), 0)^2/0.8",
          "max(x, y) - max(0.2 - abs(y - x), 0)^2/0.8", "min(x, y) - max(0.2 - abs(y - x), 0)^3",
          "smin(x, y, z)", "smin(x, y, -1)"}) {
        const Expr smooth = with_smooth_minima(*parse(text));
        EXPECT_EQ(count_of(smooth, Op::SmoothMin), 0U) << text << " is " << smooth.canonical();
    }
    for (const char* text : {"mix(y, x, h) - 0.2*h*(1 - h)", "mix(x, y, h) - 0.3*h*(1 - h)",
                             "mix(y, x, h) + 0.3*h*(1 - h)", "mix(y, z, h) - 0.3*h*(1 - h)",
                             "mix(y, x, h) - 0.3*h*(2 - h)"}) {
        const Expr smooth = with_smooth_minima(*parse(with_ramp(text, "0.5 + 0.5*(y - x)/0.3")));
        EXPECT_EQ(count_of(smooth, Op::SmoothMin), 0U) << text << " is " << smooth.canonical();
    }
}

}  // namespace
}  // namespace zeroset::smooth_minima_test
