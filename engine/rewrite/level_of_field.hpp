#pragma once

#include "engine/expr/expr.hpp"

#include <memory>
#include <optional>

namespace zeroset {

/// A field whose values at points are compared with a level.
struct LevelOfField {
    std::shared_ptr<const Field> field;
    Expr level;  ///< without x, y and z
};

/// The field and the level of an f that is field(x, y, z) - level or level - field(x, y, z):
/// neither scaled, nor at another point, nor restricted. Nothing for any other f.
std::optional<LevelOfField> level_of_field(const Expr& f);

}  // namespace zeroset
