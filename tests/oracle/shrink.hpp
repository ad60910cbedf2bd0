#pragma once

#include "engine/expr/expr.hpp"
#include "tests/property/expression_inclusion.hpp"

#include <optional>
#include <utility>
#include <vector>

// Makes a formula and a box on which something fails as simple as they can be.

namespace zeroset::test {

template <class Real>
struct FormulaOnBox {
    Expr expr;
    Box4<Real> box;
};

/// Formulas with fewer operators: with one of them replaced by one of its operands, by x
/// or by 1, the most drastic ones first. All of them could have been parsed.
std::vector<Expr> simpler_formulas(const Expr& expr);

/// Boxes that are narrower or have shorter ends, in one variable.
template <class Real>
std::vector<Box4<Real>> simpler_boxes(const Box4<Real>& box);

/// The first of the candidates that fails, too.
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

/// Fails, too, and nothing simpler that was tried does. `fails` says the same each time.
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
