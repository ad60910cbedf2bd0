#include "tests/support/oracle/field_level.hpp"

#include "tests/support/sample_field.hpp"

#include <array>
#include <cstddef>

namespace zeroset::test {

std::optional<FieldAtLevel> field_level(const Expr& expr) {
    const Node& root = expr.node(expr.root());
    Node level{.op = Op::Constant};
    NodeId of = root.a;
    const bool is_less = root.op == Op::Subtract && expr.node(root.a).op == Op::Constant;
    if (is_less) {
        level.lo = expr.node(root.a).lo;
        level.hi = expr.node(root.a).hi;
        of = root.b;
    } else if (root.op == Op::Subtract || root.op == Op::Add) {
        const Node& number = expr.node(root.b);
        if (number.op != Op::Constant) return std::nullopt;
        const bool adds = root.op == Op::Add;
        level.lo = adds ? -number.hi : number.lo;
        level.hi = adds ? -number.lo : number.hi;
    }
    const Node& field = root.op == Op::Field ? root : expr.node(of);
    if (field.op != Op::Field || field.number != 0) return std::nullopt;
    int axis = 0;
    for (const NodeId id : {field.a, field.b, field.c}) {
        const Node& operand = expr.node(id);
        if (operand.op != Op::Variable || operand.number != axis++) return std::nullopt;
    }
    return FieldAtLevel{.field = field.field, .level = level};
}

int sign_on_ray(const Field& field, const Node& level, const RayQuestion& ray, double t) {
    std::array<MpfrNumber, 3> point;
    for (std::size_t i = 0; i < 3; ++i)
        point[i] = MpfrNumber(ray.eye[i]) + MpfrNumber(ray.direction[i]) * MpfrNumber(t);
    const Reference value = field_reference(field, point[0], point[1], point[2]);
    if (!value.defined) return 0;
    const MpfrNumber number = (MpfrNumber(level.lo) + MpfrNumber(level.hi)) / MpfrNumber(2.0);
    return (value.value - number).sign();
}

}  // namespace zeroset::test
