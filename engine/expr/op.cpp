#include "engine/expr/op.hpp"

#include <array>
#include <cassert>

namespace zeroset {
namespace {

constexpr std::array table{
#define ZEROSET_OP(id, method, spelling, arity, notation, about) \
    OpInfo{Op::id, #id, spelling, arity, Notation::notation, about},
#include "engine/expr/op.def"
#undef ZEROSET_OP
};

}  // namespace

std::span<const OpInfo> operators() { return table; }

const OpInfo& op_info(Op op) {
    const auto index = static_cast<std::size_t>(op) - static_cast<std::size_t>(Op::Negate);
    assert(index < table.size());
    return table[index];
}

int arity(Op op) { return op == Op::Constant || op == Op::Variable ? 0 : op_info(op).arity; }

}  // namespace zeroset
