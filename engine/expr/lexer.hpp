#pragma once

#include "engine/expr/parse.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <string_view>
#include <vector>

namespace zeroset {

enum class TokenKind : std::uint8_t { Number, Name, Symbol, End };

struct Token {
    TokenKind kind;
    std::string_view text;  ///< a part of the text; empty at the end
    std::size_t offset;     ///< in bytes
};

/// The text's tokens, the last of them End. The text must outlive them.
std::expected<std::vector<Token>, ParseError> tokenize(std::string_view text);

}  // namespace zeroset
