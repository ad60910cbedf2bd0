#pragma once

#include "app/cli/options/options.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/prepare.hpp"

#include <string>
#include <vector>

namespace zeroset {

/// A surface to be timed.
struct BenchItem {
    std::string name;
    ReadDocument read;
};

/// The gallery's surfaces from papers, all seen from the default direction.
std::vector<BenchItem> gallery_suite();

/// The whole gallery, in the views that the window shows, all in the standard look.
std::vector<BenchItem> whole_gallery();

/// Reads the surfaces of a JSON file: {"camera": {direction, distance, fov}, "surfaces": [{name, f,
/// domain}]}; w is 0.5.
OrInputError<std::vector<BenchItem>> suite_of_file(const std::string& path);

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
