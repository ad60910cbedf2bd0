#pragma once

#include "engine/expr/expr.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// Functions made of several operators (functions.def).
enum class Composed : std::uint8_t {
#define ZEROSET_FUNCTION(id, name, least, most, arguments, meaning) id,
#include "engine/language/vocabulary/functions.def"
#undef ZEROSET_FUNCTION
};

/// A function of the language.
struct Function {
    std::string_view name;
    int least;  ///< number of arguments
    int most;   ///< -1: any number
    std::string_view arguments;
    std::string_view meaning;          ///< one line
    std::optional<Op> op;              ///< of op.def, or
    std::optional<Composed> composed;  ///< of functions.def, or
    std::string_view body = {};        ///< of library.def, in the language itself

    /// Whether it is sum or its kin, whose second argument is a name.
    [[nodiscard]] bool repeats() const {
        return composed == Composed::Sum || composed == Composed::Product ||
               composed == Composed::Least || composed == Composed::Greatest;
    }
    /// Whether it is of library.def.
    [[nodiscard]] bool is_of_library() const { return !body.empty(); }
    [[nodiscard]] bool takes(std::size_t arguments_given) const;
    /// "2 arguments", "1 or 2 arguments", "2 or more arguments".
    [[nodiscard]] std::string arity_text() const;
};

/// All functions: those of op.def, those of functions.def, those of library.def.
std::span<const Function> functions();
/// By name or by another usual spelling (arcsin, sgn, tg); nullptr when there is none.
const Function* find_function(std::string_view name);
/// All spellings that find_function knows.
std::vector<std::string_view> function_spellings();
/// The function whose value at f(a) is a, which "f^-1" means: asin for sin. nullptr: none.
const Function* inverse_of(const Function& function);

/// The node of a function of op.def, or of functions.def without what the elaborator writes out:
/// sum and its kin, psh and csd. `arguments`: as many as it takes.
NodeId make_function(ExprBuilder& builder, const Function& function,
                     std::span<const NodeId> arguments);

}  // namespace zeroset
