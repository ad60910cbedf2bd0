#pragma once

#include "engine/language/parse.hpp"
#include "engine/view/box.hpp"

#include <optional>

namespace zeroset {

/// The clip box that plotting commands in a program's text ask for: their ranges, and where a graph
/// z = f(x, y) has none for z the heights that it reaches over them, without a few far ones and at
/// most twice its width. Axes that nothing is known of are those of the usual box. Nothing where no
/// command gives a range.
std::optional<Box> asked_box(const Program& program);

}  // namespace zeroset
