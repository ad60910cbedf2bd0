#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/patch_model.hpp"

#include <array>
#include <memory>

namespace zeroset {

/// The modeler of the patch whose coordinates are these functions of x and y, with the same
/// parameters; nullptr where an operator in them has no model anywhere.
std::shared_ptr<const PatchModeler> patch_modeler(const std::array<Expr, 3>& point);

}  // namespace zeroset
