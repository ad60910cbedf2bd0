#include "engine/level_sets/function_nodes.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

// The nodes of the implicit extension 1.0 of 3MF: their names, and what operators that it lacks are
// made of. Comparisons are its select(A, B, C, D): C where A < B, else D.

namespace zeroset {
namespace {

struct NodeName {
    Op op;
    std::string_view node;
};
/// The operators that are nodes as they stand.
constexpr std::array node_names{NodeName{.op = Op::Add, .node = "addition"},
                                NodeName{.op = Op::Subtract, .node = "subtraction"},
                                NodeName{.op = Op::Multiply, .node = "multiplication"},
                                NodeName{.op = Op::Divide, .node = "division"},
                                NodeName{.op = Op::Oriented, .node = "division"},
                                NodeName{.op = Op::Sqrt, .node = "sqrt"},
                                NodeName{.op = Op::Abs, .node = "abs"},
                                NodeName{.op = Op::Sign, .node = "sign"},
                                NodeName{.op = Op::Floor, .node = "floor"},
                                NodeName{.op = Op::Ceil, .node = "ceil"},
                                NodeName{.op = Op::Mod, .node = "mod"},
                                NodeName{.op = Op::Min, .node = "min"},
                                NodeName{.op = Op::Max, .node = "max"},
                                NodeName{.op = Op::Exp, .node = "exp"},
                                NodeName{.op = Op::Log, .node = "log"},
                                NodeName{.op = Op::Log10, .node = "log10"},
                                NodeName{.op = Op::Log2, .node = "log2"},
                                NodeName{.op = Op::Sin, .node = "sin"},
                                NodeName{.op = Op::Cos, .node = "cos"},
                                NodeName{.op = Op::Tan, .node = "tan"},
                                NodeName{.op = Op::Asin, .node = "arcsin"},
                                NodeName{.op = Op::Acos, .node = "arccos"},
                                NodeName{.op = Op::Atan, .node = "arctan"},
                                NodeName{.op = Op::Atan2, .node = "arctan2"},
                                NodeName{.op = Op::Angle, .node = "arctan2"},
                                NodeName{.op = Op::Sinh, .node = "sinh"},
                                NodeName{.op = Op::Cosh, .node = "cosh"},
                                NodeName{.op = Op::Tanh, .node = "tanh"}};

/// The node that an operator is as it stands; empty: there is none.
std::string_view node_of(Op op) {
    const auto* const found = std::ranges::find(node_names, op, &NodeName::op);
    return found == node_names.end() ? std::string_view() : found->node;
}

std::string reference(std::string_view name, std::string_view identifier,
                      const std::string& output) {
    return "<i:" + std::string(name) + " identifier=\"" + std::string(identifier) + "\" ref=\"" +
           output + "\"/>";
}

/// Why an operator cannot be written.
std::string refusal(const Node& node) {
    if (node.op == Op::Where)
        return tr(
            "f is undefined in places within it, which 3MF's implicit functions cannot say; a "
            "mesh can be saved instead");
    const std::string name(op_info(node.op).spelling);
    return filled(
        tr("3MF's implicit functions have no node for {0}; a mesh can be saved instead"),
        {node.op == Op::Field ? tr("volumes, noise, soft balls and special functions") : name});
}

/// The operators that are made of several nodes.
constexpr std::array composed{Op::Negate,   Op::IntPower, Op::OddRoot,   Op::Round, Op::Cot,
                              Op::AngleSin, Op::AngleCos, Op::Length,    Op::Asinh, Op::Acosh,
                              Op::Atanh,    Op::Less,     Op::LessEqual, Op::And,   Op::Or,
                              Op::Not,      Op::If};

bool can_be_written(Op op) {
    return !node_of(op).empty() || std::ranges::find(composed, op) != composed.end();
}

bool is_condition(Op op) {
    return op == Op::Less || op == Op::LessEqual || op == Op::And || op == Op::Or || op == Op::Not;
}

}  // namespace

FunctionNodes::FunctionNodes() {
    const std::string name = fresh_name();
    xml_ += "<i:decomposevector identifier=\"" + name + "\"><i:in>" +
            reference("vectorref", "A", "inputs.pos") +
            "</i:in><i:out><i:scalar identifier=\"x\"/><i:scalar identifier=\"y\"/><i:scalar "
            "identifier=\"z\"/></i:out></i:decomposevector>\n";
    coordinates_ = {name + ".x", name + ".y", name + ".z"};
}

std::string FunctionNodes::fresh_name() { return "n" + std::to_string(++count_); }

FunctionNodes::Output FunctionNodes::constant(double value) {
    const std::string text = digits_of(value);
    Output& known = known_["=" + text];
    if (!known.empty()) return known;
    const std::string name = fresh_name();
    xml_ += "<i:constant identifier=\"" + name + "\" value=\"" + text +
            "\"><i:out><i:scalar identifier=\"value\"/></i:out></i:constant>\n";
    return known = name + ".value";
}

FunctionNodes::Output FunctionNodes::node(std::string_view kind,
                                          std::initializer_list<Output> inputs) {
    std::string list;
    char letter = 'A';
    for (const Output& input : inputs)
        list += reference("scalarref", std::string(1, letter++), input);
    Output& known = known_[std::string(kind) + list];
    if (!known.empty()) return known;
    const std::string name = fresh_name();
    const std::string tag = "i:" + std::string(kind);
    xml_ += "<" + tag + " identifier=\"" + name + "\"><i:in>" + list +
            "</i:in><i:out><i:scalar identifier=\"result\"/></i:out></" + tag + ">\n";
    return known = name + ".result";
}

std::expected<FunctionNodes::Output, std::string> FunctionNodes::leaf(
    const Node& given, std::span<const double> values) {
    if (given.op == Op::Variable) {
        if (given.number < variable_w) return coordinate(given.number);
        const auto index = static_cast<std::size_t>(given.number - variable_w);
        return constant(index < values.size() ? values[index] : 0.0);
    }
    const double value = given.lo == given.hi ? given.lo : std::midpoint(given.lo, given.hi);
    if (!std::isfinite(value))
        return std::unexpected(tr("it has a constant that is no number; 3MF could not say it"));
    return constant(value);
}

std::expected<FunctionNodes::Output, std::string> FunctionNodes::add(
    const Expr& expr, std::span<const double> values) {
    std::vector<Output> outputs;
    outputs.reserve(expr.nodes().size());
    for (const Node& given : expr.nodes()) {
        if (arity(given.op) == 0) {
            auto output = leaf(given, values);
            if (!output) return output;
            outputs.push_back(std::move(*output));
            continue;
        }
        if (!can_be_written(given.op)) return std::unexpected(refusal(given));
        Operands operands{.a = outputs[given.a], .b = outputs[given.b], .c = outputs[given.c]};
        // A condition holds where its number is above 0.
        if (given.op == Op::If && !is_condition(expr.node(given.a).op))
            operands.a = truth(operands.a);
        outputs.push_back(of_operator(given, operands));
    }
    return outputs.back();
}

FunctionNodes::Output FunctionNodes::of_operator(const Node& given, const Operands& operands) {
    const auto& [a, b, c] = operands;
    const std::string_view kind = node_of(given.op);
    if (!kind.empty()) return arity(given.op) == 1 ? node(kind, {a}) : node(kind, {a, b});
    if (given.op == Op::If) return node("select", {constant(0.0), a, b, c});
    return is_condition(given.op) ? of_condition(given.op, a, b) : of_function(given, a, b);
}

FunctionNodes::Output FunctionNodes::of_function(const Node& given, const Output& a,
                                                 const Output& b) {
    if (given.op == Op::Negate) return node("subtraction", {constant(0.0), a});
    if (given.op == Op::IntPower) return power(a, given.number);
    if (given.op == Op::OddRoot) return odd_root(a, given.number);
    if (given.op == Op::Round) return node("floor", {node("addition", {a, constant(0.5)})});
    if (given.op == Op::Cot) return node("division", {node("cos", {a}), node("sin", {a})});
    if (given.op == Op::Length) {
        const Output squares =
            node("addition", {node("multiplication", {a, a}), node("multiplication", {b, b})});
        return node("sqrt", {squares});
    }
    if (given.op == Op::AngleSin || given.op == Op::AngleCos) {
        const Output angle = node("arctan2", {a, b});
        const Output times = node("multiplication", {constant(given.number), angle});
        return node(given.op == Op::AngleSin ? "sin" : "cos", {times});
    }
    return inverse_hyperbolic(given.op, a);
}

FunctionNodes::Output FunctionNodes::truth(const Output& a) {
    return node("select", {constant(0.0), a, constant(1.0), constant(0.0)});
}

FunctionNodes::Output FunctionNodes::of_condition(Op op, const Output& a, const Output& b) {
    const Output no = constant(0.0);
    const Output yes = constant(1.0);
    if (op == Op::Less) return node("select", {a, b, yes, no});
    if (op == Op::LessEqual) return node("select", {b, a, no, yes});
    if (op == Op::And) return node("min", {truth(a), truth(b)});
    if (op == Op::Or) return node("max", {truth(a), truth(b)});
    return node("select", {no, a, no, yes});
}

FunctionNodes::Output FunctionNodes::power(const Output& base, int exponent) {
    // The node pow is not specified for bases below 0.
    if (exponent < 0) return node("division", {constant(1.0), power(base, -exponent)});
    if (exponent == 0) return constant(1.0);
    if (exponent == 1) return base;
    const Output half = power(base, exponent / 2);
    const Output square = node("multiplication", {half, half});
    return exponent % 2 == 0 ? square : node("multiplication", {square, base});
}

FunctionNodes::Output FunctionNodes::odd_root(const Output& a, int degree) {
    const Output exponent = constant(1.0 / degree);
    return node("multiplication", {node("sign", {a}), node("pow", {node("abs", {a}), exponent})});
}

FunctionNodes::Output FunctionNodes::inverse_hyperbolic(Op op, const Output& a) {
    const Output one = constant(1.0);
    if (op == Op::Atanh) {
        const Output quotient =
            node("division", {node("addition", {one, a}), node("subtraction", {one, a})});
        return node("multiplication", {constant(0.5), node("log", {quotient})});
    }
    const Output square = node("multiplication", {a, a});
    if (op == Op::Acosh) {
        const Output root = node("sqrt", {node("subtraction", {square, one})});
        return node("log", {node("addition", {a, root})});
    }
    const Output root = node("sqrt", {node("addition", {square, one})});
    const Output log = node("log", {node("addition", {node("abs", {a}), root})});
    return node("multiplication", {node("sign", {a}), log});
}

}  // namespace zeroset
