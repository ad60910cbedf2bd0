#include "engine/volume/files/grid_pieces.hpp"

#include "engine/volume/files/sample_file.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <functional>

namespace zeroset {

GridSize size_of_extent(const Extent& extent) {
    GridSize size{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::int64_t samples = extent[2 * i + 1] - extent[2 * i] + 1;
        size[i] = static_cast<std::uint64_t>(std::max<std::int64_t>(samples, 0));
    }
    return size;
}

Expected<GridPiece> joined(const std::vector<GridPiece>& pieces) {
    if (pieces.size() == 1) return pieces.front();
    GridPiece whole{.extent = pieces.front().extent, .samples = pieces.front().samples};
    for (const GridPiece& piece : pieces) {
        for (std::size_t i = 0; i < 3; ++i) {
            whole.extent[2 * i] = std::min(whole.extent[2 * i], piece.extent[2 * i]);
            whole.extent[2 * i + 1] = std::max(whole.extent[2 * i + 1], piece.extent[2 * i + 1]);
        }
        if (piece.samples.type != whole.samples.type)
            return std::unexpected("its pieces have samples of several types");
    }
    const GridSize size = whole.samples.size = size_of_extent(whole.extent);
    std::uint64_t there = 0;
    for (const GridPiece& piece : pieces)
        there += piece.samples.count();
    const auto bytes = bytes_of(size, whole.samples.type);
    constexpr const char* holes = "its pieces leave points between them out";
    // Before there is room for them
    if (!bytes || *bytes / size_of(whole.samples.type) > there) return std::unexpected(holes);
    const auto room = room_for_samples(*bytes);
    if (!room) return no_memory_for_samples(*bytes);
    const std::size_t width = size_of(whole.samples.type);
    std::vector<bool> filled(*bytes / width);
    for (const GridPiece& piece : pieces) {
        const GridSize& own = piece.samples.size;
        const auto* from = static_cast<const std::byte*>(piece.samples.data.get());
        for (std::uint64_t row = 0; row < own[1] * own[2]; ++row, from += own[0] * width) {
            const auto shift = [&](std::size_t i) {
                return static_cast<std::uint64_t>(piece.extent[2 * i] - whole.extent[2 * i]);
            };
            const std::uint64_t at = shift(0) + size[0] * (shift(1) + row % own[1] +
                                                           size[1] * (shift(2) + row / own[1]));
            std::memcpy(room.get() + at * width, from, own[0] * width);
            std::fill_n(filled.begin() + static_cast<std::ptrdiff_t>(at), own[0], true);
        }
    }
    if (!std::ranges::all_of(filled, std::identity())) return std::unexpected(holes);
    whole.samples.data = room;
    return whole;
}

}  // namespace zeroset
