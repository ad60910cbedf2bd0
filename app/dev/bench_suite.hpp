#pragma once

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

}  // namespace zeroset
