#pragma once

#include "engine/expr/op.hpp"

#include <ostream>
#include <set>
#include <string>

namespace zeroset {

/// Prints a row of op.def for GoogleTest.
inline void PrintTo(const OpInfo& info, std::ostream* out) { *out << info.name; }

namespace test {

/// Whether operand number `operand` (0, 1, 2) is a condition.
inline bool takes_condition(const OpInfo& info, int operand) {
    if (info.op == Op::If) return operand == 0;
    if (info.op == Op::Where) return operand == 1;
    return info.notation == Notation::Logic;
}
/// Whether the operator's value is a condition.
inline bool is_condition(const OpInfo& info) {
    return info.notation == Notation::Logic || info.notation == Notation::Compare;
}

/// The names of the operators that are not among these.
inline std::string missing_operators(const std::set<Op>& those) {
    std::string names;
    for (const OpInfo& info : operators()) {
        if (!those.contains(info.op)) names += std::string(info.name) + ' ';
    }
    return names;
}

/// The name of a test over a row of op.def.
inline std::string op_name(const auto& parameter) { return std::string(parameter.param.name); }

}  // namespace test
}  // namespace zeroset
