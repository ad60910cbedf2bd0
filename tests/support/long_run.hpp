#pragma once

#include <vector>

namespace zeroset::test {

/// True in a long run, where ZEROSET_LONG is set in the environment, as by the nightly script: a
/// test of many like cases tries all of them then, and in the usual run only some of each kind.
bool is_long_run();

/// Returns the cases to try: in the usual run without those that take long.
template <class Case>
std::vector<Case> cases_to_try(std::vector<Case> cases) {
    if (!is_long_run()) std::erase_if(cases, [](const Case& tried) { return tried.takes_long; });
    return cases;
}

/// Number of random formulas that a test tries: ZEROSET_FORMULAS in the environment, else `usual`,
/// in a long run four times as many.
int formulas_to_try(int usual);

}  // namespace zeroset::test
