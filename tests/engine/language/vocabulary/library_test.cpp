// Compares the functions of library.def with plain arithmetic.

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "tests/support/library_references.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

namespace zeroset::test::library_test {
namespace {

/// Returns a random value for a parameter; some parameters choose a case.
double parameter(RandomNumbers& random, const std::string& function, std::size_t index) {
    if (function == "f_polytubes" && index == 0) return random.between(1, 7);
    const bool counts_octaves =
        (function == "NoiseP" && index == 0) || (function == "f_ridged_mf" && index == 2);
    if (counts_octaves) return random.between(1, 7);
    if (function == "NoiseW") return random.between(0, 1);
    const bool helix = function.contains("helix");
    const bool chooses = (helix || function == "f_spiral") && index == 5;
    if (chooses) return std::array{0.0, 0.5, 1.0, 2.0}[random.below(4)];
    if (helix && index == 6) return random.one_in(3) ? 0 : random.uniform(-90, 90);
    if (random.one_in(8) && function.ends_with("2d")) return 0;
    if (random.one_in(4) && function.starts_with("f_algbr") && index == 2) return 0;
    return random.uniform(0.2, 2);
}

std::string number_text(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "(%.17g)", value);
    return text.data();
}

std::string call_text(const Function& function, const Arguments& at) {
    std::string text = std::string(function.name) + "(x, y, z";
    for (int i = 3; i < function.least; ++i)
        text += ", " + number_text(at.p[static_cast<std::size_t>(i) - 3]);
    return text + ")";
}

TEST(Library, FunctionsAreWhatTheirDocumentationTells) {
    const References known = library_references();
    for (const Function& function : functions()) {
        if (!function.is_of_library() || function.is_word()) continue;
        const std::string name(function.name);
        ASSERT_TRUE(known.contains(name)) << name;
        RandomNumbers random(7);
        for (int round = 0; round < 60; ++round) {
            Arguments at{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2), {}};
            for (std::size_t i = 0; i < at.p.size(); ++i)
                at.p[i] = parameter(random, name, i);
            const std::string text = call_text(function, at);
            const auto expr = parse(text);
            ASSERT_TRUE(expr) << text << ": " << expr.error().reason;
            ASSERT_TRUE(expr->parameters().empty()) << text;
            const double value = value_at(*expr, {at.x, at.y, at.z, 0}).value;
            const double expected = known.at(name)(at);
            ASSERT_NEAR(value, expected, 1e-9 * std::max(1.0, std::abs(expected)))
                << text << " at " << at.x << ", " << at.y << ", " << at.z;
        }
    }
}

/// A parameter that chooses a case may be a slider: the choice is made where f is computed.
TEST(Library, CasesMayBeChosenByParameters) {
    const auto expr = parse("f_helix1(x, y, z, 2, 3, 0.1, 0.6, 1, s, 30)");
    ASSERT_TRUE(expr);
    for (const double s : {0.5, 1.0, 2.0}) {
        const Arguments at{0.3, -0.2, 0.9, {2, 3, 0.1, 0.6, 1, s, 30}};
        const std::array parameters{s};
        const double value = value_at(*expr, {at.x, at.y, at.z, 0}, parameters).value;
        EXPECT_NEAR(value, library_references().at("f_helix1")(at), 1e-12);
    }
}

TEST(Library, NamesOfTheTextMeanNothingInIt) {
    const auto program =
        read_program("pi := 2; d := 7; c := 5\nf_ph(x, y, z) = 1\nf_radial(x,y,z) = d c pi");
    ASSERT_TRUE(program);
    const double radial = value_at(program->surfaces[1], {0.4, 0.3, -0.8, 0}).value;
    EXPECT_NEAR(radial, std::fmod(std::atan2(0.4, -0.8) / (2 * std::numbers::pi) + 0.75, 1) - 70,
                1e-12);
}

}  // namespace
}  // namespace zeroset::test::library_test
