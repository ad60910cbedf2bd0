#include "engine/level_sets/function_nodes.hpp"

#include "engine/base/digits.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

// The nodes of the implicit extension 1.0 of 3MF: their names, and what operators that it lacks are
// made of. Comparisons are its select(A, B, C, D): C where A < B, else D.

namespace zeroset {
namespace {

/// The node that an operator is as it stands; empty: there is none.
std::string_view node_of(Op op) {
    switch (op) {
        case Op::Add: return "addition";
        case Op::Subtract: return "subtraction";
        case Op::Multiply: return "multiplication";
        case Op::Divide:
        case Op::Oriented: return "division";
        case Op::Sqrt: return "sqrt";
        case Op::Abs: return "abs";
        case Op::Sign: return "sign";
        case Op::Floor: return "floor";
        case Op::Ceil: return "ceil";
        case Op::Mod: return "mod";
        case Op::Min: return "min";
        case Op::Max: return "max";
        case Op::Exp: return "exp";
        case Op::Log: return "log";
        case Op::Log10: return "log10";
        case Op::Log2: return "log2";
        case Op::Sin: return "sin";
        case Op::Cos: return "cos";
        case Op::Tan: return "tan";
        case Op::Asin: return "arcsin";
        case Op::Acos: return "arccos";
        case Op::Atan: return "arctan";
        case Op::Atan2:
        case Op::Angle: return "arctan2";
        case Op::Sinh: return "sinh";
        case Op::Cosh: return "cosh";
        case Op::Tanh: return "tanh";
        default: return "";
    }
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
    return filled(tr("3MF's implicit functions have no node for {0}; a mesh can be saved instead"),
                  {node.op == Op::Field ? tr("volumes, noise and soft balls") : name});
}

bool can_be_written(Op op) {
    switch (op) {
        case Op::Constant:
        case Op::Variable:
        case Op::Negate:
        case Op::IntPower:
        case Op::OddRoot:
        case Op::Round:
        case Op::Cot:
        case Op::AngleSin:
        case Op::AngleCos:
        case Op::Length:
        case Op::Asinh:
        case Op::Acosh:
        case Op::Atanh:
        case Op::Less:
        case Op::LessEqual:
        case Op::And:
        case Op::Or:
        case Op::Not:
        case Op::If: return true;
        default: return !node_of(op).empty();
    }
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

std::expected<FunctionNodes::Output, std::string> FunctionNodes::add(
    const Expr& expr, std::span<const double> values) {
    std::vector<Output> outputs;
    outputs.reserve(expr.nodes().size());
    for (const Node& node : expr.nodes()) {
        if (!can_be_written(node.op)) return std::unexpected(refusal(node));
        if (node.op == Op::Constant) {
            const double value = node.lo == node.hi ? node.lo : std::midpoint(node.lo, node.hi);
            if (!std::isfinite(value))
                return std::unexpected(
                    tr("it has a constant that is no number; 3MF could not say it"));
            outputs.push_back(constant(value));
        } else if (node.op == Op::Variable) {
            const bool axis = node.number < variable_w;
            const auto index = static_cast<std::size_t>(std::max(node.number - variable_w, 0));
            outputs.push_back(axis ? coordinate(node.number)
                                   : constant(index < values.size() ? values[index] : 0.0));
        } else {
            // What counts as a condition is above 0.
            const bool chooses = node.op == Op::If && !is_condition(expr.node(node.a).op);
            if (chooses) outputs.push_back(truth(outputs[node.a]));
            Node joined = node;
            if (chooses) joined.a = static_cast<NodeId>(outputs.size() - 1);
            Output result = of_operator(joined, outputs);
            if (chooses) outputs.pop_back();
            outputs.push_back(std::move(result));
        }
    }
    return outputs.back();
}

FunctionNodes::Output FunctionNodes::of_operator(const Node& given,
                                                 const std::vector<Output>& outputs) {
    const Output& a = outputs[given.a];
    const Output& b = outputs[given.b];
    const std::string_view kind = node_of(given.op);
    if (!kind.empty()) return arity(given.op) == 1 ? node(kind, {a}) : node(kind, {a, b});
    if (given.op == Op::If) return node("select", {constant(0.0), a, b, outputs[given.c]});
    return is_condition(given.op) ? of_condition(given, a, b) : of_function(given, a, b);
}

FunctionNodes::Output FunctionNodes::of_function(const Node& given, const Output& a,
                                                 const Output& b) {
    switch (given.op) {
        case Op::Negate: return node("subtraction", {constant(0.0), a});
        case Op::IntPower: return power(a, given.number);
        case Op::OddRoot: return odd_root(a, given.number);
        case Op::Round: return node("floor", {node("addition", {a, constant(0.5)})});
        case Op::Cot: return node("division", {node("cos", {a}), node("sin", {a})});
        case Op::Length:
            return node("sqrt", {node("addition", {node("multiplication", {a, a}),
                                                   node("multiplication", {b, b})})});
        case Op::AngleSin:
        case Op::AngleCos: {
            const Output angle = node("arctan2", {a, b});
            const Output times = node("multiplication", {constant(given.number), angle});
            return node(given.op == Op::AngleSin ? "sin" : "cos", {times});
        }
        default: return inverse_hyperbolic(given.op, a);
    }
}

FunctionNodes::Output FunctionNodes::truth(const Output& a) {
    return node("select", {constant(0.0), a, constant(1.0), constant(0.0)});
}

FunctionNodes::Output FunctionNodes::of_condition(const Node& given, const Output& a,
                                                  const Output& b) {
    const Output no = constant(0.0);
    const Output yes = constant(1.0);
    switch (given.op) {
        case Op::Less: return node("select", {a, b, yes, no});
        case Op::LessEqual: return node("select", {b, a, no, yes});
        case Op::And: return node("min", {truth(a), truth(b)});
        case Op::Or: return node("max", {truth(a), truth(b)});
        default: return node("select", {no, a, no, yes});
    }
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
