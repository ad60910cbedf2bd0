#pragma once

#include "document/look.hpp"

namespace zeroset::ui {

/// A look as the window names it, in the person's language.
const char* shown_name(Look look);

}  // namespace zeroset::ui
