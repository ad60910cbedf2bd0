#pragma once

#include "engine/expr/op.hpp"

#include <ostream>
#include <string>

namespace zeroset {

/// How GoogleTest prints a row of op.def.
inline void PrintTo(const OpInfo& info, std::ostream* out) { *out << info.name; }

namespace test {

/// The name of a test over a row of op.def.
inline std::string op_name(const auto& parameter) { return std::string(parameter.param.name); }

}  // namespace test
}  // namespace zeroset
