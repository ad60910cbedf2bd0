#pragma once

#include "engine/volume/files/header_text.hpp"
#include "engine/volume/samples.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace zeroset {

/// The first and last points of a grid along x, y and z.
using Extent = std::array<std::int64_t, 6>;
GridSize size_of_extent(const Extent& extent);

/// Samples of a part of a grid.
struct GridPiece {
    Extent extent{};
    Samples samples;
};

/// The grid that pieces lie in. They may share points, but must leave none out.
Expected<GridPiece> joined(const std::vector<GridPiece>& pieces);

}  // namespace zeroset
