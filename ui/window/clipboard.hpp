#pragma once

#include <string>

namespace zeroset::ui {

/// The desktop's clipboard as UTF-8; while a Window is alive.
std::string clipboard();
void set_clipboard(const std::string& text);

}  // namespace zeroset::ui
