#pragma once

#include <array>
#include <optional>
#include <string>

namespace zeroset {

/// The ends of a range that a plotting command gives x, y or z, as typed.
struct AskedRange {
    std::string lo, hi;
};
using AskedBox = std::array<std::optional<AskedRange>, 3>;

}  // namespace zeroset
