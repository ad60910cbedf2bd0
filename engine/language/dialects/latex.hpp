#pragma once

#include "engine/language/dialects/source_text.hpp"

#include <string_view>

namespace zeroset {

/// A text in which LaTeX's \sum_{i=1}^{3} a and \prod are sum(a, i, 1, 3) and prod(...), \text{and}
/// is a word, and lines of align and its like are one equation where a line has no relation of its
/// own.
SourceText latex_in_words(std::string_view typed);

}  // namespace zeroset
