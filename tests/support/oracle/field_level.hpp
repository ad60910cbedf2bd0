#pragma once

#include "engine/expr/expr.hpp"
#include "tests/support/oracle/ray_question.hpp"

#include <memory>
#include <optional>

namespace zeroset::test {

/// A field at the point (x, y, z) less a constant, or the negative of that.
struct FieldAtLevel {
    std::shared_ptr<const Field> field;
    Node level;
};
/// The formula as that, or nullopt.
std::optional<FieldAtLevel> field_level(const Expr& expr);

/// The sign of the field less the level at a point of a ray; 0 where it is 0 or not defined.
int sign_on_ray(const Field& field, const Node& level, const RayQuestion& ray, double t);

}  // namespace zeroset::test
