#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Words and signs of texts as C has them: scripts of surf and POV-Ray, formulas of others.

namespace zeroset {

enum class ScriptKind : std::uint8_t { Number, Name, Text, Sign, End };

/// A view of the script, which must outlive it. Of a Text the part between its quotes.
struct ScriptToken {
    ScriptKind kind = ScriptKind::End;
    std::string_view text = {};
    std::size_t line = 1;  ///< from 1
};

/// Splits any text into tokens; the last one is End. Remarks are left out, /* */ within each other
/// where `nested`. Signs of two characters are == != <= >= && ||; every other one is one byte.
std::vector<ScriptToken> script_tokens(std::string_view text, bool nested = false);

/// Reads tokens one after the other; beyond the end there is End.
class TokenReader {
public:
    explicit TokenReader(std::vector<ScriptToken> tokens) : tokens_(std::move(tokens)) {}

    [[nodiscard]] const ScriptToken& peek(std::size_t ahead = 0) const;
    const ScriptToken& next();
    [[nodiscard]] bool at_end() const { return peek().kind == ScriptKind::End; }
    [[nodiscard]] bool at_sign(std::string_view sign, std::size_t ahead = 0) const;
    [[nodiscard]] bool at_name(std::string_view name, std::size_t ahead = 0) const;
    /// Passes over the sign or name if it is next.
    bool take_sign(std::string_view sign);
    bool take_name(std::string_view name);
    [[nodiscard]] std::size_t line() const { return peek().line; }
    [[nodiscard]] std::size_t position() const { return at_; }
    void go_to(std::size_t position) { at_ = position; }
    [[nodiscard]] std::span<const ScriptToken> tokens() const { return tokens_; }
    /// Adds tokens behind the end; the last one should be an End.
    void append(std::span<const ScriptToken> tokens);
    /// Puts tokens in place of those from `begin` up to the next one, and goes on with them.
    void replace_from(std::size_t begin, std::span<const ScriptToken> tokens);
    /// Leaves only the first `count` tokens, at least one.
    void truncate(std::size_t count) { tokens_.resize(count); }
    /// Passes over what is between the bracket that is next and the one that closes it.
    void skip_block(std::string_view open, std::string_view close);

private:
    std::vector<ScriptToken> tokens_;
    std::size_t at_ = 0;
};

}  // namespace zeroset
