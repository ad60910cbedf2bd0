#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// Readings and errors: how a statement was understood, or why a text could not be.

namespace zeroset {

/// A likely word in the place of one that is not known.
struct Mend {
    std::string word;  ///< as it is typed
    std::string by;

    bool operator==(const Mend&) const = default;
};

struct ParseError {
    std::size_t offset;                       ///< in bytes from the start of the text
    std::string reason;                       ///< what is wrong, one line
    std::string hint;                         ///< what to type instead; may be empty
    bool unfinished = false;                  ///< the text is right so far, but stops too early
    std::optional<Mend> mend = std::nullopt;  ///< of the word at `offset`, where one is likely
};

enum class StatementKind : std::uint8_t { Value, Function, Surface };

/// How a statement was understood.
struct Reading {
    StatementKind kind;
    std::size_t offset;  ///< start of the statement, in bytes of the text
    std::string text;    ///< the statement with every operator written out; the text of a surface
                         ///< can be parsed again, unless it is long, cut and ends with "..."
    std::vector<std::string> notes = {};  ///< unusual readings, and what to type for the other
                                          ///< meaning; one line each
};

/// Limits of a text; a text that exceeds one is refused.
struct ProgramLimits {
    static constexpr std::size_t text = 2'000'000;  ///< bytes
    static constexpr std::size_t statements = 100'000;
    static constexpr std::size_t surfaces = 100;
    static constexpr std::size_t parameters = 200;
    static constexpr std::size_t nodes = 1'000'000;  ///< all surfaces together
};

}  // namespace zeroset
