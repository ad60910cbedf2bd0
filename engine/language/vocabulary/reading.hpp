#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Readings and errors: how a statement was understood, or why a text could not be.

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

/// A text that asks for more is refused.
struct ProgramLimits {
    static constexpr std::size_t text = 2'000'000;  ///< bytes
    static constexpr std::size_t statements = 100'000;
    static constexpr std::size_t surfaces = 100;
    static constexpr std::size_t parameters = 200;
    static constexpr std::size_t nodes = 1'000'000;  ///< of all surfaces together
};

}  // namespace zeroset
