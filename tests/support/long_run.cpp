#include "tests/support/long_run.hpp"

#include <cstdlib>

namespace zeroset::test {

bool is_long_run() { return std::getenv("ZEROSET_LONG") != nullptr; }

int formulas_to_try(int usual) {
    const char* const wanted = std::getenv("ZEROSET_FORMULAS");
    if (wanted != nullptr) return std::atoi(wanted);
    return is_long_run() ? 4 * usual : usual;
}

}  // namespace zeroset::test
