// Random formulas in the notation of programs read as the same graph as in the language's own
// notation: logical operators, choices, remainders, comments, line breaks.

#include "engine/language/parse.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset::program_text_property_test {
namespace {

/// One formula in two spellings: `plain` uses words and functions with all parentheses.
struct Spelled {
    std::string plain;
    std::string fancy;
};

class Speller {
public:
    explicit Speller(test::RandomNumbers& random) : random_(random) {}

    Spelled number(int depth) {
        if (depth == 0) return leaf();
        const Spelled a = number(depth - 1);
        switch (random_.below(7)) {
            case 0: {
                const Spelled b = number(depth - 1);
                return {"mod(" + a.plain + ", " + b.plain + ")",
                        "(" + a.fancy + ")" + space() + "%" + space() + "(" + b.fancy + ")"};
            }
            case 1: {
                const Spelled when = condition(depth - 1);
                const Spelled b = number(depth - 1);
                return {"if(" + when.plain + ", " + a.plain + ", " + b.plain + ")",
                        "(" + when.fancy + space() + "?" + space() + a.fancy + space() + ":" +
                            space() + b.fancy + ")"};
            }
            case 2: {
                const Spelled when = condition(depth - 1);
                return {"(" + a.plain + ")*if(" + when.plain + ", 1, 0)",
                        "(" + a.fancy + ")*(" + when.fancy + ")"};
            }
            case 3: return {"abs(" + a.plain + ")", "(|" + a.fancy + "|)"};
            case 4: return {"-(" + a.plain + ")", "-" + remark() + "(" + a.fancy + ")"};
            default: break;
        }
        const Spelled b = number(depth - 1);
        return {"((" + a.plain + ") + (" + b.plain + "))",
                "(" + a.fancy + space() + "+" + line() + b.fancy + ")"};
    }

    Spelled condition(int depth) {
        if (depth > 0) {
            switch (random_.below(4)) {
                case 0: return joined(depth, "and", {"&", "&&", "and", "∧"});
                case 1: return joined(depth, "or", {"|", "||", "or", "∨"});
                case 2: {
                    const Spelled of = condition(depth - 1);
                    return {"(not (" + of.plain + "))", "!" + space() + "(" + of.fancy + ")"};
                }
                default: break;
            }
        }
        const Spelled a = number(depth / 2);
        const Spelled b = number(depth / 2);
        const std::string left = "(" + a.plain + ")";
        const std::string right = "(" + b.plain + ")";
        const std::string up = left + " <= " + right + " and " + right + " <= " + left;
        const std::array<Spelled, 4> comparisons{{{left + " < " + right, "<"},
                                                  {left + " >= " + right, ">="},
                                                  {"(" + up + ")", "=="},
                                                  {"(not (" + up + "))", "!="}}};
        const Spelled& chosen = comparisons.at(random_.below(4));
        return {chosen.plain, a.fancy + space() + chosen.fancy + space() + b.fancy};
    }

private:
    Spelled leaf() {
        const std::string text =
            std::array<const char*, 6>{"x", "y", "z", "2", "0.5", "k"}.at(random_.below(6));
        if (text != "0.5" || random_.one_in(2)) return {text, text};
        return {"0.5", "(0,5)"};
    }

    Spelled joined(int depth, const std::string& word, std::array<const char*, 4> signs) {
        const Spelled a = condition(depth - 1);
        const Spelled b = condition(depth - 1);
        const std::string sign = signs.at(random_.below(4));
        const bool is_word = sign == word;
        return {"((" + a.plain + ") " + word + " (" + b.plain + "))",
                "((" + a.fancy + ")" + (is_word ? " " : space()) + sign +
                    (is_word ? " " : space()) + "(" + b.fancy + "))"};
    }

    std::string space() {
        return std::array<const char*, 5>{"", " ", "  ", "\t", "/* remark */"}.at(random_.below(5));
    }
    std::string remark() { return random_.one_in(4) ? "/* - */" : ""; }
    std::string line() {
        return std::array<const char*, 5>{" ", "\n", " // + x\n", " # (\n", "\n% )\n"}.at(
            random_.below(5));
    }

    test::RandomNumbers& random_;
};

std::string key_of_text(const std::string& text) {
    const auto program = read_program(text);
    if (!program) return program.error().reason;
    return program->surfaces.size() == 1 ? program->surfaces.front().key() : "several surfaces";
}

TEST(ProgramText, ReadsAsItIsMeant) {
    test::RandomNumbers random(41);
    for (int i = 0; i < 10'000 && !testing::Test::HasFailure(); ++i) {
        const Spelled both = Speller(random).number(1 + i % 4);
        const std::string plain = "x + (" + both.plain + ")";
        const std::string fancy = "x + (" + both.fancy + ")";
        EXPECT_EQ(key_of_text(fancy), key_of_text(plain)) << fancy << "\n" << plain;
    }
}

TEST(ProgramText, KeepsRestrictionsApart) {
    test::RandomNumbers random(42);
    for (int i = 0; i < 5'000 && !testing::Test::HasFailure(); ++i) {
        const Spelled both = Speller(random).condition(1 + i % 3);
        EXPECT_EQ(key_of_text("x = y, y < z + 1 and (" + both.fancy + ")"),
                  key_of_text("x = y, y < z + 1 and (" + both.plain + ")"))
            << both.fancy << "\n"
            << both.plain;
    }
}

/// Consecutive statements give one surface each, however their lines start and end.
TEST(ProgramText, HasAStatementALine) {
    constexpr std::array<std::string_view, 8> statements{
        "x + y = 1", "-x + z", "- (y - z) = 2", "-y",
        "|x| - 1",   "[x]^2",  "-sin(x)\n*y",   "max(x\n-y, z)"};
    constexpr std::array<std::string_view, 6> ends{"\n", ";", "\n\n", " // =\n", "; \n", " # -\n"};
    test::RandomNumbers random(43);
    for (int i = 0; i < 5'000 && !testing::Test::HasFailure(); ++i) {
        std::string text;
        std::vector<std::string> keys;
        for (std::size_t n = 1 + random.below(5); n > 0; --n) {
            const std::string statement(statements.at(random.below(statements.size())));
            keys.push_back(key_of_text(statement));
            text += statement;
            text += ends.at(random.below(ends.size()));
        }
        const auto program = read_program(text);
        ASSERT_TRUE(program) << text << program.error().reason;
        ASSERT_EQ(program->surfaces.size(), keys.size()) << text;
        for (std::size_t k = 0; k < keys.size(); ++k)
            EXPECT_EQ(program->surfaces[k].key(), keys[k]) << text;
    }
}

/// Decimal commas are read as points where no list is possible, and each gets a note.
TEST(ProgramText, TakesDecimalCommasWhereNoListCanBeMeant) {
    constexpr std::array<std::string_view, 9> patterns{
        "? x + y = 1",  "x^2 + y^2 = ?", "(x - ?)(y + 1) = z",   "sin(?) + x",   "pow(x, ?) = y",
        "x = y, z < ?", "x = y {z < ?}", "f(u) = u; f(?) + x y", "{x < ?: y, z}"};
    test::RandomNumbers random(44);
    for (int i = 0; i < 5'000 && !testing::Test::HasFailure(); ++i) {
        const std::string left = std::to_string(random.below(100));
        const std::string right = std::to_string(random.below(1'000));
        std::string comma(patterns.at(random.below(patterns.size())));
        std::string point = comma;
        comma.replace(comma.find('?'), 1, left + "," + right);
        point.replace(point.find('?'), 1, left + "." + right);
        EXPECT_EQ(key_of_text(comma), key_of_text(point)) << comma;
        const auto program = read_program(comma);
        ASSERT_TRUE(program) << comma;
        EXPECT_EQ(program->readings.back().notes.size(), 1) << comma;
    }
}

}  // namespace
}  // namespace zeroset::program_text_property_test
