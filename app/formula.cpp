#include "app/formula.hpp"

#include "app/text.hpp"
#include "engine/expr/parse.hpp"
#include "jit/compile.hpp"

#include <chrono>

namespace zeroset {

std::expected<Expr, InputError> read_formula(std::string_view text) {
    auto expr = parse(text);
    if (!expr) {
        const ParseError& error = expr.error();
        const std::string hint = error.hint.empty() ? "" : "; " + error.hint;
        return std::unexpected(InputError{error.reason + hint, column_of(text, error.offset),
                                          std::string(line_at(text, error.offset))});
    }
    const bool in_space =
        expr->uses_variable(0) || expr->uses_variable(1) || expr->uses_variable(2);
    if (!in_space) {
        return wrong_input(
            "there is no x, y or z in it, so it is no surface; type an equation such as "
            "x^2 + y^2 + z^2 = 1");
    }
    return std::move(*expr);
}

std::expected<Formula, InputError> compile_formula(std::string_view text) {
    const auto start = std::chrono::steady_clock::now();
    auto expr = read_formula(text);
    if (!expr) return std::unexpected(expr.error());
    auto kernel = jit::compile(*expr);
    if (!kernel) {
        return wrong_input("the formula cannot be compiled: " + kernel.error().message);
    }
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    return Formula{std::string(text), std::move(*expr), std::move(*kernel), elapsed.count()};
}

std::string describe(const InputError& error) {
    std::string text = "error: " + error.reason + "\n";
    if (!error.column || error.line.empty()) return text;
    const auto [line, caret] = excerpt(error.line, *error.column - 1);
    return text + "  " + line + "\n  " + std::string(caret, ' ') + "^\n";
}

}  // namespace zeroset
