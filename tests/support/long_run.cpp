#include "tests/support/long_run.hpp"

#include <cstdlib>

namespace zeroset::test {

bool is_long_run() { return std::getenv("ZEROSET_LONG") != nullptr; }

int formulas_to_try(int usual) {
    const char* const wanted = std::getenv("ZEROSET_FORMULAS");
    return wanted == nullptr ? usual : std::atoi(wanted);
}

}  // namespace zeroset::test
