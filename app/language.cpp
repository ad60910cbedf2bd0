#include "app/language.hpp"

#include "app/commands.hpp"
#include "engine/expr/functions.hpp"

#include <iostream>
#include <string_view>
#include <utility>

namespace zeroset {
namespace {

struct Line {
    std::string_view typed;
    std::string_view meaning;
};

constexpr Line statements[] = {
    {"x^2 + y^2 + z^2 = 1", "an equation: a surface, where both sides are equal"},
    {"x^2 + y^2 - z", "an expression: the surface where it is 0"},
    {"x^2 + y^2 = 1, -1 < z < 1", "a surface, only where the inequalities hold; also {z < 1}"},
    {"a = 2", "a constant, for all statements"},
    {"f(u, v) = u^2 + v^2", "a function, for all statements; it cannot call itself"},
    {"; or a new line", "between statements; a line that ends in an operator goes on"},
    {"# a remark", "up to the end of the line"},
};

constexpr Line names[] = {
    {"x y z w", "the variables; t is another name of w"},
    {"r, rho", "sqrt(x^2 + y^2 + z^2), sqrt(x^2 + y^2)"},
    {"theta \u03b8, phi \u03c6", "the angles atan2(y, x) and acos(z/r)"},
    {"pi \u03c0, tau \u03c4, e, golden", "3.14159..., 2 pi, 2.71828..., (1 + sqrt 5)/2"},
    {"a, k, c_1, \u03b1", "any other letter is a parameter with a slider; its value is 1 at first"},
};

constexpr Line expressions[] = {
    {"12  .5  1e-3", "numbers, with a decimal point"},
    {"+ - * / ^", "^ is right-associative; -x^2 is -(x^2); also ** \u00d7 \u00b7 \u00f7 \u2212"},
    {"2x  x(x+3)  xy  2xy^2", "products need no *; 1/2x is (1/2)*x"},
    {"( ) [ ] { }  |x|", "brackets; absolute value"},
    {"x\u00b2  x^(1/3)  x^-2", "powers; a root of odd degree takes negative numbers, too"},
    {"sin x  sin 2x  ln xy", "a function without parentheses takes the product behind it"},
    {"sin^2 x  sin^-1 x", "(sin x)^2, but the inverse function asin x"},
    {"\\frac{a}{b}  \\sqrt{x}  \\sin", "LaTeX as copied from a paper"},
    {"x < y  x <= y < z", "conditions, for if, { } and behind a comma; joined by and, or, not"},
    {"{x < 0: -x, x}", "cases, the same as if(x < 0, -x, x)"},
};

constexpr std::string_view grammar = R"grammar(text      = statement { (";" | line end) statement }
statement = logic { "," logic | "{" logic { "," logic } "}" }
logic     = both { "or" both }
both      = negation { "and" negation }
negation  = "not" negation | relation
relation  = sum { ("=" | "<" | ">" | "<=" | ">=") sum }
sum       = product { ("+" | "-") product }
product   = signed { ("*" | "/") signed | power }
signed    = { "+" | "-" } power
power     = operand { "^" signed | superscript }
operand   = number | name | "(" logic ")" | "[" logic "]" | "{" logic "}" | "|" logic "|"
          | function [ "^" signed ] ( "(" logic { "," logic } ")" | bare )
          | "{" logic ":" sum { "," logic ":" sum } [ "," sum ] "}"
          | "\frac" part part | "\sqrt" [ "[" logic "]" ] part
bare      = signed { power of a name }
part      = operand | digit
)grammar";

template <std::size_t Size>
ui::HelpSection section(std::string title, const Line (&lines)[Size]) {
    ui::HelpSection result{std::move(title), {}};
    for (const Line& line : lines)
        result.entries.push_back({std::string(line.typed), std::string(line.meaning)});
    return result;
}

/// In Markdown's table cells a bar is written with a backslash, also in code.
std::string cell(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '|') result += '\\';
        result += c;
    }
    return result;
}

}  // namespace

std::vector<ui::HelpSection> language_help() {
    std::vector<ui::HelpSection> help{section("Statements", statements),
                                      section("Names", names),
                                      section("Expressions", expressions),
                                      {"Functions", {}}};
    for (const Function& function : functions()) {
        const std::string call =
            std::string(function.name) + "(" + std::string(function.arguments) + ")";
        help.back().entries.push_back({call, std::string(function.meaning)});
    }
    return help;
}

std::string language_page() {
    std::string page =
        "# The formula language\n\n"
        "This page is what `zeroset language` prints, from the program's own tables.\n";
    for (const ui::HelpSection& section : language_help()) {
        page += "\n## " + section.title + "\n\n| type | meaning |\n|---|---|\n";
        for (const ui::HelpEntry& entry : section.entries)
            page += "| `" + cell(entry.typed) + "` | " + cell(entry.meaning) + " |\n";
    }
    page += "\n## Grammar\n\nA product without `*` binds like one with it.\n\n```\n" +
            std::string(grammar) + "```\n";
    return page;
}

int run_language() {
    std::cout << language_page();
    return exit_ok;
}

}  // namespace zeroset
