#pragma once

#include "document/document.hpp"
#include "ui/model/shown.hpp"

namespace zeroset::ui {

/// Draws how sections show values: map, level and window. Edits the document's `section_values`.
void draw_section_values(Document& document, const ShownPicture& picture);
/// The number of its rows: 0 where no section shows values.
float section_values_rows(const Document& document);

}  // namespace zeroset::ui
