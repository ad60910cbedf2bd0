#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace zeroset {

enum class Op : std::uint8_t {
    Constant,
    Variable,
#define ZEROSET_OP(id, method, spelling, arity, notation, about) id,
#include "engine/expr/op.def"
#undef ZEROSET_OP
};

enum class Notation : std::uint8_t {
    Prefix,
    Infix,
    Power,
    Root,
    Call,
    Compare,
    Logic,
    Internal,
    Wave
};

/// A row of op.def.
struct OpInfo {
    Op op;
    std::string_view name;  ///< the enumerator's name
    std::string_view spelling;
    int arity;
    Notation notation;
    std::string_view about;  ///< for the user's list of functions; empty if not typed as one
};

/// All operators but the leaves, in the order of op.def.
std::span<const OpInfo> operators();
/// The row of an operator that is not a leaf.
const OpInfo& op_info(Op op);
/// How many operands; a leaf has none.
int arity(Op op);

}  // namespace zeroset
