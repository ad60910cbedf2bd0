#pragma once

#include "engine/expr/expr.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

struct ParseError {
    std::size_t offset;       ///< in bytes from the start of the text
    std::string reason;       ///< what is wrong, one line
    std::string hint;         ///< what to type instead; may be empty
    bool unfinished = false;  ///< the text is right so far, but stops too early
};

enum class StatementKind : std::uint8_t { Value, Function, Surface };

/// A statement as it was understood.
struct Reading {
    StatementKind kind;
    std::size_t offset;  ///< of the statement in the text, bytes
    std::string text;    ///< with every operator written out; the text of a surface parses to it;
                         ///< long ones are cut and end with "..."
    std::vector<std::string> notes = {};  ///< what was read in an unusual way, and what to type for
                                          ///< the other; one line each
};

/// What a text says. Surfaces share the numbering of the parameters.
struct Program {
    std::vector<Expr> surfaces;  ///< f of f = 0, restricted by Op::Where; at least one
    std::vector<Reading> readings;
    std::vector<std::string> parameters;  ///< single letters without a definition
};

/// A text that asks for more is refused.
struct ProgramLimits {
    static constexpr std::size_t text = 2'000'000;  ///< bytes
    static constexpr std::size_t statements = 100'000;
    static constexpr std::size_t surfaces = 100;
    static constexpr std::size_t parameters = 200;
    static constexpr std::size_t nodes = 1'000'000;  ///< of all surfaces together
};

/// Reads the statements of a text (resources/docs/language.md). Time and memory are bounded
/// whatever it says.
std::expected<Program, ParseError> read_program(std::string_view text);

/// Reads an expression with the functions and values of a program (its text, which can be read) and
/// with its parameters, in their order; others are an error. Offsets are of the expression.
std::expected<Expr, ParseError> read_value(std::string_view expression, std::string_view program,
                                           std::span<const std::string> parameters);

/// Reads the one formula of a text, which may also be constant, even undefined (1/0).
std::expected<Expr, ParseError> parse(std::string_view text);

}  // namespace zeroset
