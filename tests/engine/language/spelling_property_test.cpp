// Random formulas typed in many ways read as the same graph: spacing, products without a sign,
// Unicode, LaTeX.

#include "engine/language/parse.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

namespace zeroset::spelling_property_test {
namespace {

enum class Binding { Loose, Power, Atom };

/// One formula in two spellings; `plain` has every operator and parenthesis.
struct Spelled {
    std::string plain;
    std::string fancy;
    Binding binding = Binding::Atom;  ///< how strongly `fancy` binds
};

class Speller {
public:
    explicit Speller(test::RandomNumbers& random) : random_(random) {}

    Spelled formula(int depth) {
        if (depth == 0) return leaf();
        switch (random_.below(9)) {
            case 0:
            case 1: return sum(depth);
            case 2:
            case 3: return product(depth);
            case 4: return quotient(depth);
            case 5: return power(depth);
            case 6: return call(depth);
            case 7: return radical_or_bars(depth);
            default: return choice(depth);
        }
    }

private:
    std::string one_of(std::initializer_list<const char*> texts) {
        return texts.begin()[random_.below(texts.size())];
    }
    std::string space() { return random_.one_in(2) ? "" : one_of({" ", "  ", "\t", "\\,", "~"}); }
    static std::string group(const std::string& text) { return "(" + text + ")"; }

    std::string brackets(const std::string& text) {
        const auto pair = std::array<std::array<std::string, 2>, 6>{
            {{"(", ")"},
             {"[", "]"},
             {"{", "}"},
             {"\\left(", "\\right)"},
             {"( ", " )"},
             {"(\n", ")"}}}.at(random_.below(6));
        return pair[0] + text + pair[1];
    }

    /// Spells an operand of an operator that binds as `least`, in brackets if it needs them.
    std::string operand(const Spelled& of, Binding least) {
        return of.binding < least || random_.one_in(6) ? brackets(of.fancy) : of.fancy;
    }

    Spelled leaf() {
        switch (random_.below(6)) {
            case 0: return {"pi", one_of({"pi", "π", "\\pi "})};
            case 1: return {"theta", one_of({"theta", "θ", "\\theta "})};
            case 2: return {"0.5", one_of({"0.5", ".5", "5e-1", "½"})};
            case 3: return {"2", one_of({"2", "2.", "2.0"})};
            default: break;
        }
        const std::string name = one_of({"x", "y", "z", "w", "a"});
        return {name, name};
    }

    Spelled sum(int depth) {
        const Spelled a = formula(depth - 1);
        const Spelled b = formula(depth - 1);
        const bool minus = random_.one_in(2);
        const std::string sign = minus ? one_of({"-", "−", "–", "-\n"}) : one_of({"+", "+\n"});
        return {group(a.plain) + (minus ? "-" : "+") + group(b.plain),
                operand(a, Binding::Power) + space() + sign + space() + operand(b, Binding::Power),
                Binding::Loose};
    }

    Spelled product(int depth) {
        const Spelled a = formula(depth - 1);
        const Spelled b = formula(depth - 1);
        const std::string left = operand(a, Binding::Power);
        const std::string right = operand(b, Binding::Power);
        const bool by_name = std::string_view("xyzwaptθπ\\([").contains(right.front());
        const std::string between =
            by_name && random_.one_in(2)
                ? one_of({" ", "  "})
                : space() + one_of({"*", "×", "·", "⋅", "\\cdot ", "\\times "}) + space();
        return {group(a.plain) + "*" + group(b.plain), left + between + right, Binding::Loose};
    }

    Spelled quotient(int depth) {
        const Spelled a = formula(depth - 1);
        const Spelled b = formula(depth - 1);
        const std::string plain = group(a.plain) + "/" + group(b.plain);
        if (random_.one_in(2)) {
            return {plain, one_of({"\\frac{", "\\dfrac{"}) + a.fancy + "}{" + b.fancy + "}"};
        }
        return {plain,
                operand(a, Binding::Power) + space() + one_of({"/", "÷", "\\div "}) + space() +
                    operand(b, Binding::Power),
                Binding::Loose};
    }

    Spelled power(int depth) {
        const Spelled base = formula(depth - 1);
        const std::string under = operand(base, Binding::Atom);
        const auto [plain, fancy] =
            std::array<std::array<std::string, 2>, 3>{
                {{"^2", one_of({"²", "^2", "**2", " ^ 2", "^{2}", "^(2)"})},
                 {"^3", one_of({"³", "^3", "^{3}", "^(1+2)"})},
                 {"^(-1)", one_of({"⁻¹", "^-1", "^{-1}", "^(−1)"})}}}
                .at(random_.below(3));
        return {group(base.plain) + (fancy == "^(1+2)" ? fancy : plain), under + fancy,
                Binding::Power};
    }

    Spelled call(int depth) {
        const Spelled of = formula(depth - 1);
        const std::string name = one_of({"sin", "cos", "tan", "exp", "ln", "tanh"});
        const std::string typed = (random_.one_in(2) ? "\\" : "") + name;
        return {name + group(of.plain), typed + space() + brackets(of.fancy)};
    }

    Spelled radical_or_bars(int depth) {
        const Spelled of = formula(depth - 1);
        switch (random_.below(3)) {
            case 0: return {"sqrt" + group(of.plain), "\\sqrt{" + of.fancy + "}"};
            case 1: return {"sqrt" + group(of.plain), "√" + space() + group(of.fancy)};
            default: break;
        }
        const bool nested = of.fancy.contains('|');
        return {"abs" + group(of.plain),
                nested ? "\\left|" + of.fancy + "\\right|" : bars(of.fancy)};
    }
    static std::string bars(const std::string& text) { return "(|" + text + "|)"; }

    Spelled choice(int depth) {
        const Spelled a = formula(depth - 1);
        const Spelled b = formula(depth - 1);
        const auto [plain, fancy] = std::array<std::array<std::string, 2>, 2>{
            {{"<", "<"},
             {"<=", one_of({"<=", "≤", "\\le ", "\\leq ",
                            "=<"})}}}.at(random_.below(2));
        const std::string less =
            operand(a, Binding::Power) + space() + fancy + space() + operand(b, Binding::Power);
        const std::string as_if = "if(" + less + "," + space() + a.fancy + ", " + b.fancy + ")";
        const std::string as_cases = "({" + less + ":" + a.fancy + "," + space() + b.fancy + "})";
        return {
            "if(" + group(a.plain) + plain + group(b.plain) + "," + a.plain + "," + b.plain + ")",
            random_.one_in(2) ? as_if : as_cases};
    }

    test::RandomNumbers& random_;
};

TEST(Spelling, HoweverTypedReadsTheSame) {
    test::RandomNumbers random(5);
    for (int i = 0; i < 20000 && !testing::Test::HasFailure(); ++i) {
        const Spelled both = Speller(random).formula(i % 5);
        const auto plain = parse(both.plain);
        const auto fancy = parse(both.fancy);
        ASSERT_TRUE(plain.has_value()) << both.plain << ": " << plain.error().reason;
        ASSERT_TRUE(fancy.has_value()) << both.fancy << "\n"
                                       << both.plain << "\n"
                                       << fancy.error().offset << ": " << fancy.error().reason;
        EXPECT_EQ(fancy->canonical(), plain->canonical()) << both.fancy << "\n" << both.plain;
        EXPECT_EQ(fancy->key(), plain->key()) << both.fancy << "\n" << both.plain;
    }
}

}  // namespace
}  // namespace zeroset::spelling_property_test
