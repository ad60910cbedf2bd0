#pragma once

#include "engine/language/words/lexer.hpp"
#include "engine/language/words/words_defined.hpp"

#include <vector>

namespace zeroset {

/// Removes the f of numbers such as 0.5f, as programs write them, unless the text has a value f.
std::vector<Token> without_float_suffixes(std::vector<Token> tokens, const DefinedNames& defined,
                                          Notes& notes);

}  // namespace zeroset
