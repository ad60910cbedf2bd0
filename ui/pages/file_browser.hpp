#pragma once

#include "ui/model/dialog_state.hpp"
#include "ui/style/theme.hpp"

namespace zeroset::ui {

/// How the files of documents end.
inline constexpr const char* document_ending = ".zeroset.json";

/// The choice of a document's file: folders and documents of a folder, and a field for the name.
/// Finishes the choice.
void draw_file_browser(FileChoice& choice, const Palette& colors);

}  // namespace zeroset::ui
