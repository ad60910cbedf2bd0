#pragma once

#include "app/cli/bench_suite.hpp"
#include "app/cli/options/options.hpp"

#include <vector>

namespace zeroset {

/// How first pictures are timed.
struct FirstPicturePlan {
    std::vector<BenchItem> items;
    TraceSettings settings;  ///< but for the stop, which is the window's where none is given
    Size size{};             ///< of the full picture
    int repeats = 5;
};

/// Prints how long the window's way takes from an edit of a text to its first picture: of a text
/// that is new, and of one in which a number has changed. Returns the process's exit code.
int print_first_pictures(const FirstPicturePlan& plan);

}  // namespace zeroset
