#pragma once

#include "engine/expr/expr.hpp"
#include "tests/property/expression_inclusion.hpp"

#include <optional>
#include <utility>
#include <vector>

// Simplifies a formula and a box on which something fails, as far as it still fails.

namespace zeroset::test {

template <class Real>
struct FormulaOnBox {
    Expr expr;
    Box4<Real> box;
};

/// Formulas with fewer operators: one of them is replaced by one of its operands, by x or by 1, the
/// most drastic replacements first. All of them could come from the parser.
std::vector<Expr> simpler_formulas(const Expr& expr);

/// Boxes that are narrower, or have ends with fewer digits, in one variable.
template <class Real>
std::vector<Box4<Real>> simpler_boxes(const Box4<Real>& box);

/// The first simpler candidate that fails, too.
template <class Real, class Fails>
std::optional<FormulaOnBox<Real>> simpler_failure(const FormulaOnBox<Real>& failing, Fails fails) {
    for (const Expr& expr : simpler_formulas(failing.expr)) {
        if (FormulaOnBox<Real> candidate{expr, failing.box}; fails(candidate)) return candidate;
    }
    for (const Box4<Real>& box : simpler_boxes(failing.box)) {
        if (FormulaOnBox<Real> candidate{failing.expr, box}; fails(candidate)) return candidate;
    }
    return std::nullopt;
}

/// A formula and a box that fail, too, while nothing simpler that was tried does. `fails` must
/// answer the same each time.
template <class Real, class Fails>
FormulaOnBox<Real> shrunk(FormulaOnBox<Real> failing, Fails fails) {
    constexpr int most_steps = 300;
    for (int step = 0; step < most_steps; ++step) {
        auto simpler = simpler_failure(failing, fails);
        if (!simpler) break;
        failing = std::move(*simpler);
    }
    return failing;
}

}  // namespace zeroset::test
