#include "pipeline/periodic_axes.hpp"

#include "engine/expr/patch_graph.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// How a node depends on a coordinate.
struct Dependence {
    enum class Kind : std::uint8_t {
        Not,
        Linear,    ///< `slope` times it, plus what does not depend on it
        Periodic,  ///< with a period that is a rational multiple of pi
        Otherwise,
    };
    Kind kind = Kind::Not;
    double slope = 0.0;

    [[nodiscard]] bool repeats() const { return kind == Kind::Not || kind == Kind::Periodic; }
};
using Kind = Dependence::Kind;

bool is_rational(double slope) {
    constexpr double denominators = 720.0;
    const double over = std::abs(slope) * denominators;
    return over > 0.5 && over < 1e5 && std::abs(over - std::round(over)) < 1e-9 * over;
}

Dependence linear(double slope) {
    return slope == 0.0 ? Dependence() : Dependence{.kind = Kind::Linear, .slope = slope};
}

/// The dependence of a sum of two, or of a difference.
Dependence sum(const Dependence& a, const Dependence& b, double sign) {
    const auto is_linear = [](const Dependence& one) {
        return one.kind == Kind::Not || one.kind == Kind::Linear;
    };
    if (is_linear(a) && is_linear(b)) return linear(a.slope + sign * b.slope);
    if (a.repeats() && b.repeats()) return {.kind = Kind::Periodic};
    return {.kind = Kind::Otherwise};
}

bool takes_angle(Op op) { return op == Op::Sin || op == Op::Cos || op == Op::Tan || op == Op::Cot; }

/// The dependence of a product with a constant factor, or of a quotient by one; nothing for others.
std::optional<Dependence> multiple(const Expr& function, const Node& node, const Dependence& a,
                                   const Dependence& b) {
    const auto constant = [&](NodeId id) -> std::optional<double> {
        const Node& factor = function.node(id);
        return factor.op == Op::Constant ? std::optional(factor.lo) : std::nullopt;
    };
    const bool multiplies = node.op == Op::Multiply;
    if (a.kind == Kind::Linear && (multiplies || node.op == Op::Divide)) {
        if (const auto by = constant(node.b))
            return linear(multiplies ? a.slope * *by : a.slope / *by);
    }
    if (b.kind == Kind::Linear && multiplies) {
        if (const auto by = constant(node.a)) return linear(b.slope * *by);
    }
    return std::nullopt;
}

/// The dependence of a node on the coordinate, from those of its operands.
Dependence dependence_of(const Expr& function, const Node& node, int axis,
                         const std::array<Dependence, 3>& operands) {
    const auto& [a, b, c] = operands;
    if (node.op == Op::Variable) return linear(node.number == axis ? 1.0 : 0.0);
    if (node.op == Op::Negate) return sum({}, a, -1.0);
    if (node.op == Op::Add || node.op == Op::Subtract)
        return sum(a, b, node.op == Op::Add ? 1.0 : -1.0);
    if (const auto scaled = multiple(function, node, a, b)) return *scaled;
    if (takes_angle(node.op) && a.kind == Kind::Linear && is_rational(a.slope))
        return {.kind = Kind::Periodic};
    const bool is_free = a.kind == Kind::Not && b.kind == Kind::Not && c.kind == Kind::Not;
    if (is_free) return {};
    const bool repeats = a.repeats() && b.repeats() && c.repeats();
    return {.kind = repeats ? Kind::Periodic : Kind::Otherwise};
}

/// The dependence of the function on the coordinate.
Dependence dependence_on(int axis, const Expr& function) {
    std::vector<Dependence> of;
    of.reserve(function.nodes().size());
    for (const Node& node : function.nodes()) {
        const std::array ids{node.a, node.b, node.c};
        std::array<Dependence, 3> operands;
        for (std::size_t k = 0; std::cmp_less(k, arity(node.op)); ++k)
            operands.at(k) = of[ids.at(k)];
        of.push_back(dependence_of(function, node, axis, operands));
    }
    return of.back();
}

}  // namespace

std::array<bool, 3> periodic_axes(const Program& program) {
    std::array<bool, 3> periodic{};
    for (int axis = 0; axis < 3; ++axis) {
        bool repeats = true;
        bool depends = false;
        for (const Expr& function : program.surfaces) {
            if (is_patch(function)) continue;
            const Dependence on = dependence_on(axis, function);
            repeats = repeats && on.repeats();
            depends = depends || on.kind == Kind::Periodic;
        }
        periodic.at(static_cast<std::size_t>(axis)) = repeats && depends;
    }
    return periodic;
}

}  // namespace zeroset
