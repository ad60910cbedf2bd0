#pragma once

#include "engine/language/syntax/syntax.hpp"
#include "engine/language/words/words_defined.hpp"

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Private to the syntax room: a recursive descent parser with a function for each rule of the
// grammar in resources/docs/language.md.

namespace zeroset {

class SyntaxParser {
public:
    /// nullopt is an error, which is in `error_`. An error in each value would make the stack of a
    /// deeply nested formula several times as large.
    using Parsed = std::optional<SyntaxId>;

    SyntaxParser(std::vector<Token> tokens, const DefinedNames& defined, Notes notes)
        : tokens_(std::move(tokens)), defined_(defined) {
        tree_.notes = std::move(notes);
    }

    std::expected<SyntaxTree, ParseError> text();
    [[nodiscard]] std::span<const Token> tokens() const { return tokens_; }

private:
    using Rule = Parsed (SyntaxParser::*)();
    using List = std::optional<std::vector<SyntaxId>>;

    /// A step of a function's body as programs write it.
    struct BodyStep {
        enum class Kind : std::uint8_t { Value, Choice, Return };

        Kind kind;
        std::size_t offset;
        SyntaxId value = 0;               ///< the value, the result, or the condition of a choice
        std::string name = {};            ///< what has the value
        bool declares = false;            ///< the name is new
        std::vector<BodyStep> then = {};  ///< where the condition holds
        std::vector<BodyStep> otherwise = {};  ///< where it does not
    };
    /// Steps that follow others, and what follows these.
    struct FollowingSteps {
        std::span<const BodyStep> steps;
        const FollowingSteps* next;
    };

    /// Counts one more level of nesting while it lives. Every recursion passes power() or part().
    struct Level {
        explicit Level(int& depth) : depth_(depth) { ++depth_; }
        ~Level() { --depth_; }
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;

    private:
        int& depth_;
    };

    /// A call such as Y_2^{-1}(a, b), from its bracket on.
    struct Harmonic {
        std::size_t opener;
        std::string degree, order;
        bool is_negative;
    };

    // syntax_statement.cpp
    bool statement();
    void skip_label();
    bool part_of_statement(bool is_certain, std::size_t offset);
    bool skip_type_words();
    [[nodiscard]] bool declares_more() const;
    Parsed relation_of_statement(bool is_certain);
    SyntaxId with_equation_outside(SyntaxId root);
    bool restrictions_in_braces(StatementSyntax& statement);
    [[nodiscard]] bool starts_program_function() const;
    Parsed program_function();
    [[nodiscard]] bool starts_pov_function() const;
    Parsed pov_function();

    // syntax_body.cpp
    Parsed block();
    bool steps_in_braces(const Token& opener, std::vector<BodyStep>& steps);
    bool step(std::vector<BodyStep>& steps);
    bool choice_step(std::vector<BodyStep>& steps);
    bool branch(std::vector<BodyStep>& steps);
    [[nodiscard]] std::string name_in_branch(std::string name) const;
    void skip_breaks();
    Parsed result_of(std::span<const BodyStep> steps, const FollowingSteps* behind,
                     std::size_t closer);
    Parsed result_behind_values(const BodyStep& step, std::span<const BodyStep> rest,
                                const FollowingSteps* behind, std::size_t closer);
    [[nodiscard]] static bool returns_within(const BodyStep& step);
    static void add_changed(std::span<const BodyStep> steps, std::vector<std::string>& names);
    SyntaxId new_value(const Token& name, std::string_view part, std::string_view sign,
                       SyntaxId value);
    [[nodiscard]] static ParseError no_step(const Token& at);
    bool local_value(std::vector<BodyStep>& steps);
    SyntaxId zero_of(std::string_view type, std::size_t offset);
    bool named_value(std::string_view type, std::vector<BodyStep>& steps);

    // syntax_instructions.cpp
    Parsed instructions();
    Parsed instruction(const NameMap<SyntaxId>& known);
    Parsed instruction_value(const Token& word, const NameMap<SyntaxId>& known);
    Parsed instruction_number();

    // syntax_parser.cpp: operators
    Parsed choice();
    Parsed logic();
    Parsed both();
    Parsed negation();
    Parsed relation();
    Parsed sum();
    Parsed product();
    [[nodiscard]] bool next_is_remainder() const;
    [[nodiscard]] bool is_derivative() const;
    Parsed signed_power();
    Parsed negated();
    Parsed power();
    Parsed joined_by(std::string_view word, SyntaxKind kind, Rule rule);
    /// The mark of the comparison that is next, or 0.
    [[nodiscard]] char comparison() const;
    [[nodiscard]] bool starts_factor() const;
    [[nodiscard]] bool restricts() const;

    // syntax_operand.cpp
    Parsed operand();
    Parsed name(const Token& token);
    Parsed refuse_call(const Token& token, const std::string& full);
    void note_product(const Token& token, const std::string& name);
    Parsed volume(const Token& token);
    Parsed group(const Token& opener);
    Parsed cases(const Token& opener, SyntaxId condition);
    Parsed tuple(const Token& opener, SyntaxId first);
    Parsed part_of(SyntaxId vector);
    Parsed absolute(const Token& opener);
    Parsed floor_or_ceil(const Token& opener);
    Parsed fraction();
    Parsed radical(const Token& token);
    Parsed radical_operand();
    Parsed part();
    Parsed call(const Token& token, const Function& function);
    [[nodiscard]] bool is_polynomial(std::size_t at, int degree);
    [[nodiscard]] std::size_t arguments_at(std::size_t opener) const;
    [[nodiscard]] std::optional<Harmonic> harmonic_at(const Token& token) const;
    Parsed harmonic(const Token& token, const Harmonic& of);
    Parsed factorial(SyntaxId of);
    std::optional<Parsed> call_by_letter(const Token& token, const std::string& name);
    Parsed polynomial_of(const Token& token, int degree);
    [[nodiscard]] bool is_bessel(std::size_t at) const;
    Parsed bessel_call(const Token& token, const Function& function);
    void note_letter(const Token& token, const Function& function);
    void note_base(const Token& token, const std::vector<SyntaxId>& values);
    std::vector<SyntaxId> in_order_of_atan2(const Token& token, std::vector<SyntaxId> values);
    Parsed call_of_text(const Token& token);
    bool skip_to_list();
    List arguments_of(const Token& token, const Function& function);
    List arguments();
    Parsed bare_argument();
    bool is_root_of_number(const Token& token, const Function& function);
    Parsed with_exponent(SyntaxId call, const Token& token, const Function& function,
                         SyntaxId exponent);
    Parsed superscript();
    [[nodiscard]] bool starts_bare_factor() const;

    // syntax_errors.cpp
    [[nodiscard]] static ParseError wrong_count(const Token& token, const Function& function,
                                                std::size_t count);
    /// The error for `name(a, b)` that calls no function.
    [[nodiscard]] ParseError no_function(const Token& name) const;
    bool close(const Token& opener);
    std::nullopt_t refuse(ParseError error);
    std::nullopt_t fail(const Token& at, std::string reason, std::string hint = {});
    [[nodiscard]] ParseError missing_operand() const;
    [[nodiscard]] ParseError surplus() const;
    /// Whether `further` more levels are allowed; sets the error if not.
    bool may_nest(int further = 0);

    SyntaxId add(SyntaxKind kind, std::size_t offset, std::vector<SyntaxId> operands,
                 std::string_view marks = {}, std::string_view text = {});
    SyntaxId add_call(const Function& function, std::size_t offset, std::vector<SyntaxId> operands);
    void add_library_function(const Function& function, std::size_t offset);

    [[nodiscard]] const Token& next() const { return tokens_[at_]; }
    [[nodiscard]] bool next_is(std::string_view symbol) const {
        return next().kind == TokenKind::Symbol && next().text == symbol;
    }
    [[nodiscard]] bool next_is_one_of(std::initializer_list<std::string_view> symbols) const;
    [[nodiscard]] bool next_is_word(std::string_view word) const {
        return next().kind == TokenKind::Name && next().text == word;
    }
    [[nodiscard]] bool at_break() const {
        return next().kind == TokenKind::Break || next().kind == TokenKind::End;
    }
    const Token& take() { return tokens_[next().kind == TokenKind::End ? at_ : at_++]; }
    /// The text of the token before the next one.
    [[nodiscard]] std::string before() const { return std::string(tokens_[at_ - 1].text); }

    std::vector<Token> tokens_;
    const DefinedNames& defined_;
    SyntaxTree tree_;
    std::optional<ParseError> error_;
    std::size_t at_ = 0;
    std::size_t statement_start_ = 0;  ///< index of the statement's first token
    int depth_ = 0;                    ///< nesting of operands
    int brackets_ = 0;                 ///< open brackets
    int bars_ = 0;                     ///< open "|" since the last open bracket
    std::size_t branch_ = 0;           ///< branches of a body that are being read
    /// The branches that declare a name, the innermost last, each by the branches around it.
    NameMap<std::vector<std::size_t>> names_in_branches_;
    std::map<char, bool> calls_polynomial_;  ///< whether P_n with n >= 2 is called, by the letter
    int steps_read_ = 0;                     ///< steps of a body, each as often as it was read
};

}  // namespace zeroset
