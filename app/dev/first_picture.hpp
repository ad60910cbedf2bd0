#pragma once

#include "app/cli/options/options.hpp"
#include "app/dev/bench_suite.hpp"

#include <vector>

namespace zeroset {

/// Settings for timing first pictures.
struct FirstPicturePlan {
    std::vector<BenchItem> items;
    TraceSettings settings;  ///< the stop is the window's if none was given
    Size size{};             ///< of the full picture, pixels
    int repeats = 5;
};

/// Prints the times that the window takes from an edit of a text to its first picture: for a new
/// text, and for one in which a number has changed. Returns the process's exit code.
int print_first_pictures(const FirstPicturePlan& plan);

}  // namespace zeroset
