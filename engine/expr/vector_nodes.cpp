#include "engine/expr/vector_nodes.hpp"

#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"

namespace zeroset {
namespace {

/// a b, without what a factor that is 0 or 1 makes superfluous.
NodeId product_of(ExprBuilder& builder, NodeId a, NodeId b) {
    const auto left = exact_value(builder, a);
    const auto right = exact_value(builder, b);
    if (left == 0.0 || right == 0.0) return builder.constant(0.0);
    if (left == 1.0) return b;
    return right == 1.0 ? a : make_multiply(builder, a, b);
}

/// a - b, where one of them may be 0.
NodeId difference_of(ExprBuilder& builder, NodeId a, NodeId b) {
    if (exact_value(builder, b) == 0.0) return a;
    return exact_value(builder, a) == 0.0 ? make_negate(builder, b) : make_subtract(builder, a, b);
}

}  // namespace

VectorNodes make_place(ExprBuilder& builder) {
    return {builder.variable(0), builder.variable(1), builder.variable(2)};
}

VectorNodes make_sum(ExprBuilder& builder, const VectorNodes& a, const VectorNodes& b) {
    VectorNodes sum{};
    for (std::size_t k = 0; k < 3; ++k)
        sum.at(k) = make_add(builder, a.at(k), b.at(k));
    return sum;
}

VectorNodes make_difference(ExprBuilder& builder, const VectorNodes& a, const VectorNodes& b) {
    VectorNodes difference{};
    for (std::size_t k = 0; k < 3; ++k)
        difference.at(k) = difference_of(builder, a.at(k), b.at(k));
    return difference;
}

VectorNodes make_scaled(ExprBuilder& builder, NodeId factor, const VectorNodes& v) {
    return {make_multiply(builder, factor, v[0]), make_multiply(builder, factor, v[1]),
            make_multiply(builder, factor, v[2])};
}

VectorNodes make_cross(ExprBuilder& builder, const VectorNodes& a, const VectorNodes& b) {
    VectorNodes product{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3;
        const std::size_t j = (k + 2) % 3;
        const NodeId first = product_of(builder, a.at(i), b.at(j));
        product.at(k) = difference_of(builder, first, product_of(builder, a.at(j), b.at(i)));
    }
    return product;
}

NodeId make_dot(ExprBuilder& builder, const VectorNodes& a, const VectorNodes& b) {
    NodeId sum = product_of(builder, a[0], b[0]);
    for (std::size_t k = 1; k < 3; ++k) {
        const NodeId next = product_of(builder, a.at(k), b.at(k));
        const bool adds = exact_value(builder, next) != 0.0;
        if (adds) sum = exact_value(builder, sum) == 0.0 ? next : make_add(builder, sum, next);
    }
    return sum;
}

NodeId make_length(ExprBuilder& builder, const VectorNodes& v) {
    return make_call(builder, Op::Sqrt, make_dot(builder, v, v));
}

VectorNodes make_unit(ExprBuilder& builder, const VectorNodes& v) {
    const NodeId length = make_length(builder, v);
    return {make_divide(builder, v[0], length), make_divide(builder, v[1], length),
            make_divide(builder, v[2], length)};
}

}  // namespace zeroset
