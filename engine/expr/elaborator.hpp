#pragma once

#include "engine/expr/facts.hpp"
#include "engine/expr/syntax.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

// Private to parse.hpp: from trees of names to one graph.

namespace zeroset {

class Elaborator {
public:
    explicit Elaborator(const SyntaxTree& tree) : tree_(tree) {}

    std::expected<Program, ParseError> program();
    /// The last statement, an expression.
    std::expected<Expr, ParseError> last_value();
    /// The only statement, an equation or an expression; its constants may be undefined.
    std::expected<Expr, ParseError> formula();

private:
    struct Value {
        NodeId id;
        bool condition;  ///< a truth value, not a number
    };
    using Built = std::optional<Value>;  ///< without a value: `error_` says why
    using Number = std::optional<NodeId>;

    /// A name of a function's argument or of a sum's index.
    struct Binding {
        std::string_view name;
        NodeId value;
        const Binding* outer;
    };
    struct Definition {
        std::size_t statement = 0;
        SyntaxId body = 0;
        std::vector<std::string> arguments;
        bool is_function = false;
        bool in_progress = false;
        bool used = false;
        Number value;  ///< of a value, once known
    };
    using Call = std::pair<const Definition*, std::vector<NodeId>>;
    struct CallHash {
        std::size_t operator()(const Call& call) const;
    };
    struct Surface {
        std::size_t statement;
        NodeId root;
    };

    // elaborator.cpp: statements
    bool find_definitions();
    [[nodiscard]] std::optional<Definition> definition_in(std::size_t statement) const;
    bool build_statements();
    bool build_surface(std::size_t statement);
    Number equation(const StatementSyntax& statement);
    Number restricted(NodeId f, const StatementSyntax& statement);
    bool build_definition(const std::string& name, Definition& definition);
    bool add_surface(std::size_t statement, NodeId root);
    [[nodiscard]] bool uses_space(NodeId root) const;
    std::optional<std::string> function_text(const std::string& name, Definition& definition);
    std::expected<Program, ParseError> result();

    // elaborator_value.cpp: expressions
    Built build(SyntaxId id, const Binding* scope);
    Number number(SyntaxId id, const Binding* scope);
    Number condition(SyntaxId id, const Binding* scope);
    Built literal(const Syntax& syntax);
    Built name(const Syntax& syntax, const Binding* scope);
    Built built_in(std::string_view name);
    Built parameter(const std::string& name, std::size_t offset);
    Built defined_value(Definition& definition, const Syntax& syntax);
    Built sum(const Syntax& syntax, const Binding* scope);
    Built product(const Syntax& syntax, const Binding* scope);
    Built compare(const Syntax& syntax, const Binding* scope);
    Built connected(const Syntax& syntax, Op op, const Binding* scope);
    Built cases(const Syntax& syntax, const Binding* scope);
    Built call(const Syntax& syntax, const Binding* scope);
    Built repeated(const Syntax& syntax, const Binding* scope);
    Built defined_call(const Syntax& syntax, const Binding* scope);
    Number function_value(Definition& definition, const std::vector<NodeId>& arguments);

    /// The node as a value, unless the graph is too large or holds a constant that is no number.
    Built done(NodeId id, std::size_t offset, bool condition = false);
    [[nodiscard]] bool divides_by_zero(const Node& node) const;
    std::nullopt_t fail(std::size_t offset, std::string reason, std::string hint = {});

    const SyntaxTree& tree_;
    ExprBuilder builder_;
    std::vector<Facts> facts_;  ///< of the builder's nodes
    std::unordered_map<std::string, Definition> definitions_;
    std::unordered_map<std::string, std::size_t> parameter_index_;
    std::vector<std::string> parameters_;
    std::unordered_map<Call, NodeId, CallHash> calls_;
    std::vector<Surface> surfaces_;
    std::map<std::size_t, Reading> readings_;  ///< by statement
    std::optional<ParseError> error_;
    bool refuses_undefined_ = true;
    int depth_ = 0;
    std::size_t steps_ = 0;
};

}  // namespace zeroset
