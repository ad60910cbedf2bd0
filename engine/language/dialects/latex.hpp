#pragma once

#include "engine/language/dialects/source_text.hpp"

#include <string_view>

namespace zeroset {

/// Whether a text has what `write_latex` puts otherwise.
bool has_foreign_latex(std::string_view typed);

/// Writes a text of LaTeX: \sum_{i=1}^{3} a and \prod as sum(a, i, 1, 3) and prod(...), \text{and}
/// as a word, and lines of align and its like as one equation where a line has no relation of its
/// own.
void write_latex(std::string_view typed, SourceText& words);

}  // namespace zeroset
