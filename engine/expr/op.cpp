#include "engine/expr/op.hpp"

namespace zeroset {

bool is_choice(Op op) { return op == Op::Min || op == Op::Max || op == Op::If || op == Op::Where; }

bool is_alternative(Op choice, std::size_t k) {
    if (choice == Op::Where) return k == 0;
    return choice != Op::If || k > 0;
}

bool may_be_operand(Op op) {
    return is_choice(op) || op == Op::SmoothMin || op == Op::And || op == Op::Or;
}

bool is_sum(Op op) { return op == Op::Add || op == Op::Subtract; }

}  // namespace zeroset
