#pragma once

#include "engine/language/vocabulary/words_vocabulary.hpp"
#include "engine/language/words/lexer.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Private to DefinedNames: the statements that may be definitions.

namespace zeroset {

/// A statement of the form NAME = ... or NAME(a, b) = ...
struct Candidate {
    std::string name = {};
    bool is_function = false;
    bool is_certain = false;  ///< has a ":=" or a word before it, such as float
    std::size_t name_offset = 0;
    std::size_t begin = 0;  ///< start of the statement, in bytes of the text
    std::size_t end = 0;
    std::vector<std::string> arguments = {};
    std::vector<std::string> indices = {};  ///< indices of its sums and products
    std::span<const Token> value = {};      ///< the tokens after the "="
};

/// Number of times that other statements use a name.
struct NameUses {
    std::size_t all = 0;
    std::size_t calls = 0;  ///< uses with a bracket after the name
};

/// Whether a list of instructions as Fidget and libfive write them (.vm) begins here: `NAME const
/// 2` or `NAME var-x`.
bool starts_instructions(std::span<const Token> tokens);

class Candidates {
public:
    /// Searches tokens in which each run of letters, digits and "_" is one name. Tokens at offset
    /// `counted_end` or later do not count as uses.
    Candidates(std::span<const Token> tokens, std::size_t counted_end);

    /// All candidates, in the order of the text. A statement that only has indices is one without a
    /// name.
    [[nodiscard]] const std::vector<Candidate>& all() const { return candidates_; }
    [[nodiscard]] NameUses uses(std::string_view name) const;
    /// Whether the text has statements that are not certain to be definitions.
    [[nodiscard]] bool has_equations() const { return has_equations_; }
    /// The factors that the name would be the product of if it were not defined; empty: it would be
    /// no product.
    [[nodiscard]] std::vector<std::string> factors(std::string_view name) const;
    /// Whether the letter is used, or the name defined, elsewhere in the text.
    [[nodiscard]] bool is_known_factor(const std::string& factor) const;
    /// Whether the value seems to be the same at all points.
    [[nodiscard]] bool is_constant(const Candidate& candidate) const;
    /// Whether a function's value uses only its arguments and built-in names.
    [[nodiscard]] bool depends_on_arguments_only(const Candidate& candidate) const;

private:
    void read_statement(std::span<const Token> statement);
    void read_program_function(std::span<const Token> statement, std::size_t name,
                               std::size_t brace);
    void read_definition(std::span<const Token> statement, std::size_t begin, bool is_certain);
    void count_uses(std::span<const Token> tokens, std::size_t counted_end);
    void read_letters(std::string_view run);
    [[nodiscard]] std::size_t defined_start(std::string_view text, std::string_view whole) const;
    bool take_factors(std::string_view& text, std::vector<std::string>& factors) const;

    std::vector<Candidate> candidates_;
    NameMap<NameUses> uses_;
    Vocabulary vocabulary_;
    bool has_equations_ = false;
};

}  // namespace zeroset
