#pragma once

#include "engine/expr/expr.hpp"
#include "engine/expr/number.hpp"

#include <array>
#include <string_view>

namespace zeroset {

/// An irrational constant with a name: the neighbouring doubles around it.
struct NamedConstant {
    std::string_view name;
    NumberEnclosure value;
};

inline constexpr NamedConstant pi{
    .name = "pi", .value = {.lo = 0x1.921fb54442d18p+1, .hi = 0x1.921fb54442d19p+1}};
inline constexpr NamedConstant tau{
    .name = "tau", .value = {.lo = 0x1.921fb54442d18p+2, .hi = 0x1.921fb54442d19p+2}};
inline constexpr NamedConstant euler{
    .name = "e", .value = {.lo = 0x1.5bf0a8b145769p+1, .hi = 0x1.5bf0a8b14576ap+1}};
inline constexpr std::array named_constants{pi, tau, euler};

inline NodeId make_constant(ExprBuilder& builder, const NamedConstant& constant) {
    return builder.constant(constant.value.lo, constant.value.hi);
}

inline bool is_named(const Node& node, const NamedConstant& constant) {
    return node.op == Op::Constant && node.lo == constant.value.lo && node.hi == constant.value.hi;
}

}  // namespace zeroset
