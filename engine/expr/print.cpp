// Expr::canonical: the formula with every operator written out and no parenthesis that
// precedence makes needless.

#include "engine/expr/expr.hpp"
#include "engine/expr/number.hpp"

#include <string>

namespace zeroset {
namespace {

// How tightly the printed form of a node binds.
enum Precedence : int { Sum = 1, Product = 2, Sign = 3, Power = 4, Atom = 5 };

struct Printed {
    std::string text;
    int precedence;
};

std::string in_parentheses_below(const Printed& printed, int precedence) {
    return printed.precedence < precedence ? "(" + printed.text + ")" : printed.text;
}

Printed print_infix(const Node& node, const Printed& a, const Printed& b) {
    const bool sum = node.op == Op::Add || node.op == Op::Subtract;
    const int precedence = sum ? Sum : Product;
    const std::string spelling(op_info(node.op).spelling);
    // Left-associative: the right operand of the same precedence keeps its parentheses.
    return {in_parentheses_below(a, precedence) + (sum ? " " + spelling + " " : spelling) +
                in_parentheses_below(b, precedence + 1),
            precedence};
}

Printed print_operator(const Node& node, const Printed& a, const Printed& b) {
    const OpInfo& info = op_info(node.op);
    switch (info.notation) {
        case Notation::Prefix: return {"-" + in_parentheses_below(a, Sign), Sign};
        case Notation::Infix: return print_infix(node, a, b);
        case Notation::Power:
            return {in_parentheses_below(a, Atom) + "^" + std::to_string(node.number), Power};
        case Notation::Call:
        case Notation::Internal: break;
    }
    const std::string arguments = info.arity == 2 ? a.text + ", " + b.text : a.text;
    return {std::string(info.spelling) + "(" + arguments + ")", Atom};
}

Printed print_constant(const Node& node) {
    std::string text = number_text({node.lo, node.hi});
    const int precedence = text.starts_with('-') ? Sign : Atom;
    return {std::move(text), precedence};
}

}  // namespace

std::string Expr::canonical() const {
    if (nodes_.empty()) return {};
    std::vector<Printed> printed;
    printed.reserve(nodes_.size());
    for (const Node& node : nodes_) {
        if (node.op == Op::Constant) {
            printed.push_back(print_constant(node));
        } else if (node.op == Op::Variable) {
            printed.push_back({std::string(variable_name(node.number, parameters_)), Atom});
        } else {
            printed.push_back(print_operator(node, printed[node.a], printed[node.b]));
        }
    }
    return printed.back().text;
}

}  // namespace zeroset
