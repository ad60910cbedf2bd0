#pragma once

#include "engine/language/words/lexer.hpp"
#include "engine/language/words/words_defined.hpp"

#include <string_view>
#include <vector>

namespace zeroset {

/// The ":" behind the name of an equation, as it is told from others.
inline constexpr std::string_view label_mark = "name:";

/// Decides what the signs of several meanings are: "|" an absolute value or "or", "&" "and" or
/// LaTeX's mark of a column, "," a decimal point or a separator, ":" the end of a statement.
std::vector<Token> with_plain_marks(std::vector<Token> tokens, const DefinedNames& defined,
                                    Notes& notes);

}  // namespace zeroset
