#pragma once

#include <string>

namespace zeroset::ui {

/// Text of the desktop's clipboard in UTF-8. Only while a Window is alive.
std::string clipboard();
void set_clipboard(const std::string& text);

}  // namespace zeroset::ui
