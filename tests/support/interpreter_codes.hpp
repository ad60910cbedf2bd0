#pragma once

#include "engine/interpret/interpret_code.hpp"
#include "engine/real/processor.hpp"

#include <string>
#include <utility>
#include <vector>

namespace zeroset::test {

/// The interpreters, with their names, for the register widths that this machine has.
inline std::vector<std::pair<std::string, const InterpreterCode*>> interpreter_codes() {
    std::vector<std::pair<std::string, const InterpreterCode*>> codes{
        {"interpreted in 16 bytes", &interpreter_code_16()}};
    if (machine_has_avx2_fma())
        codes.emplace_back("interpreted in 32 bytes", &interpreter_code_32());
    if (machine_has_avx512()) codes.emplace_back("interpreted in 64 bytes", &interpreter_code_64());
    return codes;
}

}  // namespace zeroset::test
