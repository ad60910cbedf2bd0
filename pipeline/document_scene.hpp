#pragma once

#include "document/document.hpp"
#include "pipeline/formula.hpp"

#include <cstddef>
#include <vector>

namespace zeroset {

/// The row of each surface of the program read from joined_rows(document).
std::vector<int> surface_rows(const Document& document, const Program& program);

/// Which of the program's surfaces are visible; `rows` as for document_scene.
std::vector<std::size_t> visible_surfaces(const Document& document, const std::vector<int>& rows);

/// The surfaces of the rows that are visible, in their colours; `rows`: the row of each of the
/// formula's surfaces.
Scene document_scene(const Formula& formula, const Document& document,
                     const std::vector<int>& rows);

}  // namespace zeroset
