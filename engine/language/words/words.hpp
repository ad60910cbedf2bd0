#pragma once

#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/vocabulary/words_vocabulary.hpp"
#include "engine/language/words/lexer.hpp"
#include "engine/language/words/words_defined.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Splits runs of letters such as "xsiny" into names: built-in ones, those that the text defines,
// single letters.

namespace zeroset {

/// The name as it is printed: its letters, then "_" and the subscript.
std::string full_name(const Token& token);

/// The plain digits or letters of a subscript: "12" for c_{12} and c₁₂.
std::string subscript_text(const Token& token);

/// Whether the name is one letter, with a subscript or without.
bool is_parameter_name(std::string_view name);

class Words {
public:
    /// Learns from the tokens which letters stand alone. `defined` must outlive this object and the
    /// tokens that split() makes.
    Words(std::span<const Token> tokens, const DefinedNames& defined);

    /// The tokens with runs of letters split into names: xsiny into x, sin, y. A run that is no
    /// product of known names stays whole.
    [[nodiscard]] std::vector<Token> split(std::span<const Token> tokens, Notes& notes) const;

private:
    void push_name(const Token& token, std::vector<Token>& out, Notes& notes) const;
    void push_pieces(const Token& token, std::vector<Token>& out, Notes& notes) const;
    const Function* capital_function(std::string_view run, std::vector<std::size_t>& lengths) const;
    [[nodiscard]] bool stays_whole(const Token& token) const;
    [[nodiscard]] bool joins_unknown_name(const Token& token, const std::vector<Token>& out) const;

    Vocabulary vocabulary_;
    const DefinedNames& defined_;
    bool is_mathematica_ = false;  ///< the text has calls such as Sin[x]
};

}  // namespace zeroset
