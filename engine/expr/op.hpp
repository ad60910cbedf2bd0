#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace zeroset {

enum class Op : std::uint8_t {
    Constant,
    Variable,
#define ZEROSET_OP(id, method, spelling, arity, notation) id,
#include "engine/expr/op.def"
#undef ZEROSET_OP
};

enum class Notation : std::uint8_t { Prefix, Infix, Power, Call, Internal };

/// A row of op.def.
struct OpInfo {
    Op op;
    std::string_view name;  ///< the enumerator's name
    std::string_view spelling;
    int arity;
    Notation notation;
};

/// All operators but the leaves, in the order of op.def.
std::span<const OpInfo> operators();
/// The row of an operator that is not a leaf.
const OpInfo& op_info(Op op);
/// The function that is typed as `name`, e.g. "sqrt".
std::optional<Op> function_named(std::string_view name);

}  // namespace zeroset
