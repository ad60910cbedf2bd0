#pragma once

#include <array>
#include <cstddef>
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
    Wave,
    Lookup
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

inline constexpr std::array op_table{
#define ZEROSET_OP(id, method, spelling, arity, notation, about) \
    OpInfo{Op::id, #id, spelling, arity, Notation::notation, about},
#include "engine/expr/op.def"
#undef ZEROSET_OP
};

/// All operators but the leaves, in the order of op.def.
constexpr std::span<const OpInfo> operators() { return op_table; }

/// The row of an operator that is not a leaf.
constexpr const OpInfo& op_info(Op op) {
    return op_table[static_cast<std::size_t>(op) - static_cast<std::size_t>(Op::Negate)];
}

/// How many operands; a leaf has none.
constexpr int arity(Op op) {
    return op == Op::Constant || op == Op::Variable ? 0 : op_info(op).arity;
}

/// Whether the operator takes one of its operands and leaves others: a choice.
bool is_choice(Op op);
/// Whether operand k of a choice is one of those that it may take.
bool is_alternative(Op choice, std::size_t k);
/// Whether it is one of its operands somewhere, and does not depend on the other there: choices,
/// smooth minima and conditions.
bool may_be_operand(Op op);
/// Whether it adds or subtracts.
bool is_sum(Op op);

}  // namespace zeroset
