#pragma once

#include "engine/language/words/lexer.hpp"
#include "engine/language/words/words_defined.hpp"

#include <string_view>
#include <vector>

namespace zeroset {

/// The text of a ":" after the name of an equation, to tell it from other colons.
inline constexpr std::string_view label_mark = "name:";

/// Decides on the signs with several meanings: "|" is an absolute value or "or", "&" is "and" or
/// LaTeX's column mark, "," a decimal point or a separator, ":" the end of a statement.
std::vector<Token> with_plain_marks(std::vector<Token> tokens, const DefinedNames& defined,
                                    Notes& notes);

}  // namespace zeroset
