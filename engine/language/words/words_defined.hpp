#pragma once

#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/vocabulary/words_vocabulary.hpp"
#include "engine/language/words/lexer.hpp"

#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// The names that a text defines. They are found first, so that they are never split.

namespace zeroset {

/// Whether the word stands before a definition in some programming language: float, const, let.
bool is_type_word(std::string_view word);
/// Whether the word belongs to a declaration of what follows: `float a`, `in vec3 p`.
bool declares(const Token& word, const Token& next);

/// The degree n of T_n and U_n, Chebyshev's polynomials, and of P_n, H_n and L_n, those of
/// Legendre, Hermite and Laguerre, as far as these are read.
std::optional<int> polynomial_degree(std::string_view plain_name);

/// The function that a letter with a whole number below 100, n, m or k names, as J_2 does; nullptr:
/// none.
const Function* bessel_function(std::string_view plain_name);

/// The form of a name in which it is looked up: c_12 for c_{12} and c₁₂, theta1 for θ1.
std::string plain_name(std::string_view run);
/// Whether the run is already in the form that plain_name gives.
bool is_plain_name(std::string_view run);
/// Finds the plain name of a run in a set or map of names; returns an iterator.
template <class Names>
auto find_plain(Names& names, std::string_view run) {
    return is_plain_name(run) ? names.find(run) : names.find(plain_name(run));
}

class DefinedNames {
public:
    /// Finds the definitions in tokens in which each run of letters, digits and "_" is one name.
    /// Tokens at offset `counted_end` or later do not count as uses of a name.
    DefinedNames(std::span<const Token> tokens, std::size_t counted_end, Notes& notes);

    /// The defined name of more than one letter that the run at `offset` is, if it is one.
    [[nodiscard]] std::optional<std::string_view> find(std::string_view run,
                                                       std::size_t offset) const;
    [[nodiscard]] bool defines_value(std::string_view name) const { return values_.contains(name); }
    [[nodiscard]] bool defines_function(std::string_view name) const {
        return functions_.contains(name);
    }
    /// Whether a defined function of this name takes this number of arguments.
    [[nodiscard]] bool takes(std::string_view name, std::size_t arguments) const;
    /// Whether the name at `offset` starts an equation such as z(x, y) = x y, which means z = x y.
    [[nodiscard]] bool is_place_with_arguments(std::size_t offset) const {
        return places_.contains(offset);
    }
    [[nodiscard]] const NameSet& words() const { return words_; }

private:
    friend class DefinitionSearch;

    /// Names of arguments and indices, valid in one statement only.
    struct Scope {
        std::size_t begin;  ///< in bytes of the text
        std::size_t end;
        NameSet names;
    };

    NameSet words_;  ///< names of more than one letter
    NameSet values_;
    NameMap<std::set<std::size_t>> functions_;  ///< with the numbers of arguments they take
    std::set<std::size_t> places_;
    std::vector<Scope> scopes_;
};

}  // namespace zeroset
