#include "engine/expr/parse.hpp"

#include "engine/expr/elaborator.hpp"

namespace zeroset {

std::expected<Program, ParseError> read_program(std::string_view text) {
    const auto tree = read_syntax(text);
    if (!tree) return std::unexpected(tree.error());
    return Elaborator(*tree).program();
}

std::expected<Expr, ParseError> parse(std::string_view text) {
    const auto tree = read_syntax(text);
    if (!tree) return std::unexpected(tree.error());
    return Elaborator(*tree).formula();
}

}  // namespace zeroset
