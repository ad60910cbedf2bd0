#pragma once

#include <string>

namespace zeroset {

/// The number with up to `decimals` digits after the point, without zeros at the end, for a file.
std::string file_number(double number, int decimals);

}  // namespace zeroset
