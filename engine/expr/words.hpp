#pragma once

#include "engine/expr/lexer.hpp"

#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

// Which names a text has: built-in ones, those it defines, single letters; and how a run of letters
// such as "xsiny" is made of them.

namespace zeroset {

/// A name as it is printed: the letters, and "_" with the subscript.
std::string full_name(const Token& token);

/// Whether the name is one letter, with a subscript or without.
bool is_parameter_name(std::string_view name);

/// x y z w, t; r rho theta phi; pi tau e golden: names that no text can define.
bool is_built_in_value(std::string_view name);

class Words {
public:
    /// Reads the definitions `name = ...` and `name(a, b) = ...` and which letters stand alone.
    explicit Words(std::span<const Token> tokens);

    /// The tokens with runs of letters split into names: xsiny into x, sin, y. A run that is no
    /// product of known names stays whole.
    [[nodiscard]] std::vector<Token> split(std::span<const Token> tokens) const;

    /// Whether the text defines a function (a value) of this name.
    [[nodiscard]] bool defines_function(const std::string& name) const {
        return functions_.contains(name);
    }
    [[nodiscard]] bool defines_value(const std::string& name) const {
        return values_.contains(name);
    }

private:
    [[nodiscard]] bool is_known_letter(char letter) const;
    [[nodiscard]] bool is_known_word(std::string_view word) const;
    /// Lengths of the pieces of a run of letters; empty when it is no product of known names.
    [[nodiscard]] std::vector<std::size_t> pieces(std::string_view run, bool subscript) const;
    void read_definition(std::span<const Token> statement);
    void push_pieces(const Token& token, std::vector<Token>& out) const;

    std::unordered_set<char> letters_;
    std::unordered_set<std::string> values_;
    std::unordered_set<std::string> functions_;
};

/// The hint for a name that is not known: the nearest known one, or the product that was meant.
std::string hint_for_unknown(std::string_view name);

}  // namespace zeroset
