// Random names of any length: once a text defines a name, it is never split, and the text means the
// same as with a letter in its place.

#include "engine/expr/spelling.hpp"
#include "engine/language/parse.hpp"
#include "engine/language/vocabulary/foreign.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/words/words.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset::names_property_test {
namespace {

constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// Returns a name of several characters, often one that letters and functions could also form.
std::string random_name(test::RandomNumbers& random) {
    static constexpr std::array<std::string_view, 12> starts{"c",   "x", "sr", "th", "Iso", "rho",
                                                             "sin", "d", "e",  "pi", "_q",  "R"};
    static constexpr std::array<std::string_view, 10> ends{"1",  "2", "_2",  "x",  "0a",
                                                           "_x", "y", "_ab", "e5", "_1_b"};
    std::string name;
    if (random.one_in(3)) {
        for (std::size_t n = 2 + random.below(5); n > 0; --n)
            name += letters[random.below(letters.size())];
    } else {
        name = starts.at(random.below(starts.size()));
    }
    for (std::size_t n = random.below(3); n > 0; --n)
        name += ends.at(random.below(ends.size()));
    return name;
}

/// True if the name must be defined to be used, and means nothing else before a bracket.
bool is_free(const std::string& name) {
    const bool letter = name.size() < 2 || is_parameter_name(name);
    const bool exponent = name.starts_with('e') && is_digit(name[1]);  // as in 2e5
    return !letter && !exponent && !is_built_in(name) && !is_built_in(in_small_letters(name)) &&
           !is_type_word(name) && !error_for_foreign(name, 0) && name != "M_PI" &&
           name != "function";
}

std::string fresh_name(test::RandomNumbers& random) {
    for (;;) {
        std::string name = random_name(random);
        if (is_free(name)) return name;
    }
}

/// Returns the pattern with each "?" replaced by `name`.
std::string with_name(std::string_view pattern, const std::string& name) {
    std::string text;
    for (const char c : pattern)
        text += c == '?' ? name : std::string(1, c);
    return text;
}

/// Returns the keys of the text's surfaces or, if it cannot be read, the reason.
std::vector<std::string> surfaces_of(const std::string& text) {
    const auto program = read_program(text);
    if (!program) return {program.error().reason};
    std::vector<std::string> keys;
    for (const Expr& surface : program->surfaces)
        keys.push_back(surface.key());
    return keys;
}

TEST(Names, ThatAreDefinedAreNeverSplit) {
    constexpr std::array<std::string_view, 9> patterns{
        "?=0.1; (x - ?)^2 + y^2 = 1",
        "x^2 + ? y = 1\n? = 3/4",
        "? = 2; z = 3? + 2?^2 - sin(?) + sin ? + x/?",
        "? = x + y\n-? + z ?",
        "? = 1; ? = ? + 1; ? x + y = ?",
        "? := 4\nmax(?, x) = y",
        "const float ?=2.;\nx*? + y",
        "#declare ? = 3;\n|?| x - y{z < ?}",
        "? = 1e-2; 2? x - .5? y"};
    test::RandomNumbers random(31);
    for (int i = 0; i < 20'000 && !testing::Test::HasFailure(); ++i) {
        const std::string name = fresh_name(random);
        const std::string_view pattern = patterns.at(random.below(patterns.size()));
        const std::string text = with_name(pattern, name);
        EXPECT_EQ(surfaces_of(text), surfaces_of(with_name(pattern, "k"))) << text;
    }
}

TEST(Names, OfFunctionsCanBeCalled) {
    constexpr std::array<std::string_view, 8> patterns{
        "?(u, v) = u^2 - v; ?(x, y) = ?(z, 1)",
        "z = 2?(x, y)^2\n?(u, v) = u/v",
        "?(x,y,z,t) = x + y*z; -?(y, z, x, t) + 1",
        "?(u, v) = u; ?(u, v) = ?(v, u) + 1\n?(x, y) - z",
        "float ?(float u, float v) { return u*v; }\n?(x, y) - z",
        "#declare ? = function(u, v) { u - v };\n?(y, x) z",
        "?[u_, v_] := u v\n?[x, y] == z",
        "g(u) = ?(u, x)^2; ?(u, v) = min(u, v); g(y)"};
    test::RandomNumbers random(32);
    for (int i = 0; i < 20'000 && !testing::Test::HasFailure(); ++i) {
        const std::string name = fresh_name(random);
        const std::string_view pattern = patterns.at(random.below(patterns.size()));
        const std::string text = with_name(pattern, name);
        EXPECT_EQ(surfaces_of(text), surfaces_of(with_name(pattern, "k"))) << text;
    }
}

TEST(Names, OfArgumentsAndIndicesAreWholeInTheirStatement) {
    constexpr std::array<std::string_view, 4> patterns{
        "f(?, v) = ?^2 + 2? v; f(x, y) = z", "sum(x^? + 2?, ?, 1, 4) = y",
        "float f(float ?) { float s = 2.*?; return s*?; }\nf(x) + y",
        "f(?) = ? < 1 ? 2? : ?; f(x) + y"};
    test::RandomNumbers random(33);
    for (int i = 0; i < 5'000 && !testing::Test::HasFailure(); ++i) {
        const std::string name = fresh_name(random);
        std::string pattern(patterns.at(random.below(patterns.size())));
        if (pattern.starts_with("f(?) = ? <")) {  // its third "?" is a choice
            pattern = "f(@) = @ < 1 ? 2@ : @; f(x) + y";
            std::string text = pattern;
            for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@', at))
                text.replace(at, 1, name);
            std::ranges::replace(pattern, '@', 'k');
            EXPECT_EQ(surfaces_of(text), surfaces_of(pattern)) << text;
            continue;
        }
        const std::string text = with_name(pattern, name);
        EXPECT_EQ(surfaces_of(text), surfaces_of(with_name(pattern, "k"))) << text;
    }
}

TEST(Names, BesideTheirBeginningsAreApart) {
    test::RandomNumbers random(34);
    for (int i = 0; i < 5'000 && !testing::Test::HasFailure(); ++i) {
        const std::string name = fresh_name(random);
        const std::string longer = name + std::array{"2", "_2", "b", "_x"}.at(random.below(4));
        if (!is_free(longer)) continue;
        const std::string text =
            name + " = 3\n" + longer + " = 5\nx " + name + " + y " + longer + " = 1";
        EXPECT_EQ(surfaces_of(text), surfaces_of("x*3 + y*5 = 1")) << text;
    }
}

/// A built-in name may be defined: as a constant if another statement uses it, else as a surface if
/// it names a coordinate.
TEST(Names, ThatAreBuiltInAreConstantsWhereAnotherStatementUsesThem) {
    for (const char* const name :
         {"r", "rho", "theta", "phi", "t", "w", "e", "pi", "tau", "golden"}) {
        const std::string definition = std::string(name) + " = 1.5";
        for (const std::string& text : {definition + "\nx^2 + y = 2" + name + "^2",
                                        "x^2 + y = 2" + std::string(name) + "^2;" + definition}) {
            EXPECT_EQ(surfaces_of(text), surfaces_of("x^2 + y = 2*1.5^2")) << text;
            const auto program = read_program(text);
            ASSERT_TRUE(program) << text;
            const auto noted = std::ranges::count_if(program->readings, [](const Reading& reading) {
                return reading.notes.size() == 1;
            });
            EXPECT_EQ(noted, 1) << text;
        }
        const auto alone = surfaces_of(definition + "; y = 1");
        EXPECT_EQ(alone.size(), is_place(name) ? 2 : 1) << name;
        EXPECT_EQ(alone.back(), surfaces_of("y = 1").back()) << name;
    }
}

/// A definition can hide any built-in function; a note says so.
TEST(Names, OfBuiltInFunctionsCanBeDefined) {
    for (const Function& function : functions()) {
        if (function.repeats()) continue;
        const std::string name(function.name);
        const std::string text = name + "(u, v) := u - v^2\n" + name + "(x, y) = z";
        EXPECT_EQ(surfaces_of(text), surfaces_of("x - y^2 = z")) << text;
        const auto program = read_program(text);
        ASSERT_TRUE(program) << text;
        EXPECT_EQ(program->readings.front().notes.size(), 1) << text;
    }
}

}  // namespace
}  // namespace zeroset::names_property_test
