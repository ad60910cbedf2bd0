// The formula with every operator written out and no parenthesis that precedence makes needless.

#include "engine/expr/constants.hpp"
#include "engine/expr/expr.hpp"
#include "engine/expr/number.hpp"
#include "engine/expr/spelling.hpp"

#include <algorithm>
#include <array>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace zeroset {
namespace {

// How tightly the printed form of a node binds.
enum Precedence : int { Or = 1, And, Not, Relation, Sum, Product, Sign, Power, Atom };

int infix_precedence(Op op) {
    if (op == Op::Or) return Or;
    if (op == Op::And) return And;
    if (op == Op::Less || op == Op::LessEqual) return Relation;
    return op == Op::Add || op == Op::Subtract ? Sum : Product;
}

/// A name as it is typed: c_{1a}, because c_1a is a product.
std::string spelled(std::string_view name) {
    const std::size_t bar = name.find('_');
    if (bar == std::string_view::npos) return std::string(name);
    const std::string_view subscript = name.substr(bar + 1);
    const bool digit = !subscript.empty() && is_digit(subscript.front());
    if (!digit || std::ranges::all_of(subscript, is_digit)) return std::string(name);
    return std::string(name.substr(0, bar)) + "_{" + std::string(subscript) + "}";
}

/// Writes a graph with a stack of its own: graphs may be deeper than the machine's stack.
class Printer {
public:
    Printer(std::span<const Node> nodes, std::span<const std::string> parameters,
            std::size_t longest)
        : nodes_(nodes), parameters_(parameters), longest_(longest) {}

    std::string text(NodeId root) {
        pending_.push_back(operand(root, Or));
        while (!pending_.empty()) {
            const Piece piece = std::move(pending_.back());
            pending_.pop_back();
            if (text_.size() > longest_ || pending_.size() > most_pending()) return text_ + "...";
            if (piece.is_node) {
                print(piece.node, piece.least);
            } else {
                text_ += piece.text;
            }
        }
        return text_;
    }

private:
    /// How deep a text may begin: long ones, of which there are few, as deep as graphs get.
    [[nodiscard]] std::size_t most_pending() const {
        return (longest_ < 10'000 ? 2 : 40) * longest_;
    }

    struct Piece {
        std::string text;
        NodeId node = 0;
        int least = 0;  ///< a node that binds less tightly stands in parentheses
        bool is_node = false;
    };

    void print(NodeId id, int least) {
        std::vector<Piece> pieces;
        const int precedence = pieces_of(id, pieces);
        if (precedence < least) {
            pieces.insert(pieces.begin(), Piece{.text = "("});
            pieces.push_back({.text = ")"});
        }
        for (Piece& piece : std::views::reverse(pieces))
            pending_.push_back(std::move(piece));
    }

    static Piece operand(NodeId node, int least) {
        return {.text = {}, .node = node, .least = least, .is_node = true};
    }

    /// The pieces of a node, and how tightly they bind.
    int pieces_of(NodeId id, std::vector<Piece>& pieces) {
        const Node& node = nodes_[id];
        if (node.op == Op::Constant) {
            // Text of many operands names few numbers, again and again.
            const auto [known, is_new] = constants_.try_emplace(id);
            if (is_new) known->second = constant(node);
            pieces.push_back({.text = known->second});
            return pieces.back().text.starts_with('-') ? Sign : Atom;
        }
        if (node.op == Op::Variable) {
            pieces.push_back({.text = spelled(variable_name(node.number, parameters_))});
            return Atom;
        }
        const OpInfo& info = op_info(node.op);
        switch (info.notation) {
            case Notation::Prefix: pieces = {{.text = "-"}, operand(node.a, Sign)}; return Sign;
            case Notation::Infix:
            case Notation::Compare: return infix(node, pieces);
            case Notation::Logic:
                if (node.op != Op::Not) return infix(node, pieces);
                pieces = {{.text = "not "}, operand(node.a, Relation)};
                return Not;
            case Notation::Power:
                pieces = {operand(node.a, Atom), {.text = "^" + std::to_string(node.number)}};
                return Power;
            case Notation::Root: return root(node, pieces);
            case Notation::Internal:
                if (node.op == Op::Oriented) return infix(node, pieces);
                if (node.op == Op::Length) return length(node, pieces);
                if (node.op == Op::LogSum) return log_sum(node, pieces);
                if (node.op == Op::SmoothMin) return smooth_min(node, pieces);
                if (node.op == Op::Fold) return fold(node, pieces);
                if (node.op != Op::Angle) return cardinal(node, info, pieces);
                break;
            case Notation::Wave: return wave(node, info, pieces);
            case Notation::Lookup: return lookup(node, pieces);
            case Notation::Call: break;
        }
        return call(node, info, pieces);
    }

    static int infix(const Node& node, std::vector<Piece>& pieces) {
        const int precedence = infix_precedence(node.op);
        const std::string spelling(op_info(node.op).spelling);
        // Left-associative: a right operand of the same precedence keeps its parentheses, and a
        // comparison is no operand of a comparison.
        const int left = precedence == Relation ? Sum : precedence;
        pieces = {operand(node.a, left),
                  {.text = precedence == Product ? spelling : " " + spelling + " "},
                  operand(node.b, precedence + 1)};
        return precedence;
    }

    static int root(const Node& node, std::vector<Piece>& pieces) {
        if (node.number == 3) {
            pieces = {{.text = "cbrt("}, operand(node.a, Or), {.text = ")"}};
            return Atom;
        }
        pieces = {operand(node.a, Atom), {.text = "^(1/" + std::to_string(node.number) + ")"}};
        return Power;
    }

    /// Prints a chain of lengths, the innermost first, whose operands stand the other way round
    /// (engine/rewrite/passes.hpp).
    int length(const Node& node, std::vector<Piece>& pieces) const {
        std::vector<NodeId> legs;
        const Node* inner = &node;
        for (; nodes_[inner->a].op == Op::Length; inner = &nodes_[inner->a])
            legs.push_back(inner->b);
        legs.push_back(inner->a);
        legs.push_back(inner->b);
        for (auto leg = legs.rbegin(); leg != legs.rend(); ++leg) {
            pieces.push_back({.text = leg == legs.rbegin() ? "sqrt(" : "^2 + "});
            pieces.push_back(operand(*leg, Atom));
        }
        pieces.push_back({.text = "^2)"});
        return Atom;
    }

    /// sin(a)/a
    static int cardinal(const Node& node, const OpInfo& info, std::vector<Piece>& pieces) {
        pieces = {{.text = std::string(info.spelling) + "("},
                  operand(node.a, Or),
                  {.text = ")/"},
                  operand(node.a, Sign)};
        return Product;
    }

    static int fold(const Node& node, std::vector<Piece>& pieces) {
        pieces = {{.text = "abs(mod("}, operand(node.a, Sum), {.text = " + 1, 2) - 1)"}};
        return Atom;
    }

    static int smooth_min(const Node& node, std::vector<Piece>& pieces) {
        pieces = {{.text = "smin("},
                  operand(node.a, Or),
                  {.text = ", "},
                  operand(node.b, Or),
                  {.text = ", 1)"}};
        return Atom;
    }

    static int log_sum(const Node& node, std::vector<Piece>& pieces) {
        pieces = {{.text = "ln(exp("},
                  operand(node.a, Or),
                  {.text = ") + exp("},
                  operand(node.b, Or),
                  {.text = "))"}};
        return Atom;
    }

    static int wave(const Node& node, const OpInfo& info, std::vector<Piece>& pieces) {
        const std::string times = node.number == 1 ? "" : std::to_string(node.number) + "*";
        pieces = {{.text = std::string(info.spelling) + "(" + times + "atan2("},
                  operand(node.a, Or),
                  {.text = ", "},
                  operand(node.b, Or),
                  {.text = "))"}};
        return Atom;
    }

    /// Prints a derivative, which is never read, with the axes that it is by. What the text of a
    /// field without parentheses has from a comma on stands behind the operands: "noise, 7". A
    /// field of one number has a place for it: "besselj(2, #)".
    static int lookup(const Node& node, std::vector<Piece>& pieces) {
        std::string text = node.field->text();
        if (const std::size_t place = text.find('#');
            place != std::string::npos && !text.contains('"')) {
            pieces = {{.text = text.substr(0, place)},
                      operand(node.a, Or),
                      {.text = text.substr(place + 1)}};
            return Atom;
        }
        std::string last;
        if (const std::size_t comma = text.find(','); comma < text.find('(')) {
            last = text.substr(comma);
            text.resize(comma);
        }
        if (node.number != 0) text += "_";
        const std::array<int, 3> times = times_of(node.number);
        for (std::size_t axis = 0; axis < times.size(); ++axis)
            text.append(static_cast<std::size_t>(times[axis]), "xyz"[axis]);
        pieces = {{.text = text + "("}, operand(node.a, Or), {.text = ", "},
                  operand(node.b, Or),  {.text = ", "},      operand(node.c, Or),
                  {.text = last + ")"}};
        return Atom;
    }

    static int call(const Node& node, const OpInfo& info, std::vector<Piece>& pieces) {
        pieces = {{.text = std::string(info.spelling) + "("}, operand(node.a, Or)};
        for (const NodeId further : {node.b, node.c}) {
            if (static_cast<int>(pieces.size()) >= 2 * info.arity) break;
            pieces.push_back({.text = ", "});
            pieces.push_back(operand(further, Or));
        }
        pieces.push_back({.text = ")"});
        return Atom;
    }

    static std::string constant(const Node& node) {
        for (const NamedConstant& known : named_constants) {
            if (is_named(node, known)) return std::string(known.name);
            if (node.lo == -known.value.hi && node.hi == -known.value.lo)
                return "-" + std::string(known.name);
        }
        return number_text({.lo = node.lo, .hi = node.hi});
    }

    std::span<const Node> nodes_;
    std::span<const std::string> parameters_;
    std::size_t longest_;
    std::vector<Piece> pending_;
    std::unordered_map<NodeId, std::string> constants_;
    std::string text_;
};

/// f, and behind a comma the condition that restricts it. Nothing stands behind what is cut.
std::string with_restriction(const Expr& expr, const std::string& between, std::size_t longest) {
    if (expr.nodes().empty()) return {};
    const auto text = [&](NodeId id) {
        return Printer(expr.nodes(), expr.parameters(), longest).text(id);
    };
    const Node& root = expr.node(expr.root());
    const bool restricted = root.op == Op::Where;
    std::string f = text(restricted ? root.a : expr.root());
    if (!f.ends_with("...")) f += restricted ? between + ", " + text(root.b) : between;
    return f;
}

}  // namespace

std::string Expr::canonical() const { return with_restriction(*this, "", longest_text); }

std::string ExprBuilder::text(NodeId root, std::span<const std::string> parameters,
                              std::size_t longest) const {
    return Printer(nodes_, parameters, longest).text(root);
}

std::string equation_text(const Expr& expr, std::size_t longest) {
    return with_restriction(expr, " = 0", longest);
}

}  // namespace zeroset
