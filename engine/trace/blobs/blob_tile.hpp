#pragma once

#include "engine/trace/blobs/blob_hits.hpp"
#include "engine/trace/blobs/blob_surface.hpp"
#include "engine/trace/blobs/ray_block.hpp"
#include "engine/trace/blobs/slab_balls.hpp"
#include "engine/trace/ray_lines.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// Memory that a thread keeps from tile to tile.
struct BlobScratch {
    SlabBalls slab;
    RayLines lines;
    BallBlock block;
};

/// The rays of a tile on their way through soft balls, in blocks of 8 x 8.
class BlobTile {
public:
    /// All outlive it.
    BlobTile(const TraceFrame& frame, const Tile& tile, const BlobSurface& surface,
             BlobScratch& scratch, TileHits& hits, Counters& counters);

    /// False, and nothing done: places are not known well enough to prove anything.
    bool run();

private:
    /// Some pixels of the tile, and what is known of their rays.
    struct Block {
        int col, row, cols, rows;
        double u = 0, v = 0, u_radius = 0, v_radius = 0;
        DepthRange inside{};  ///< for all rays alike
        double bracket = 0;   ///< the widest that certifies a root on any of them
        bool certifies = false;
        std::uint64_t open = 0;  ///< rays that have not ended, by their places
        bool singly = false;     ///< where rays are inside is known ray by ray
    };
    /// The state of a block's rays at the end of a slab.
    struct RaysKnown {
        BallBlock::Numbers at;  ///< no root is before
        std::array<std::int8_t, ray_block_rays> side;
    };

    [[nodiscard]] Block block_at(int col, int row, int side) const;
    void set_bracket(Block& block) const;
    void begin_blocks();
    void trace(Block& block, RaysKnown& known);
    bool list_balls(const Block& block, double from, double to);
    [[nodiscard]] bool near_ends(const Block& block) const;
    void take_singly(Block& block);
    [[nodiscard]] double end_of(const Block& block, std::size_t place) const;
    void fill(const Block& block, const RaysKnown& known, double first);
    void end(Block& block, RaysKnown& known, double first);
    void tell(const Block& block, std::size_t place, double first);
    void leave(Block& block);

    [[nodiscard]] static std::uint32_t pixel_of(const Block& block, std::size_t place);

    const TraceFrame& frame_;
    const Tile& tile_;
    const BlobSurface& surface_;
    BlobScratch& scratch_;
    TileRays rays_;
    BlobHits hits_;
    Counters& counters_;
    static constexpr std::size_t most_blocks = std::size_t{tile_size} * tile_size / ray_block_rays;

    double tail_ = 0;
    std::size_t count_ = 0;
    std::array<Block, most_blocks> blocks_;
    std::array<RaysKnown, most_blocks> rays_of_;
};

}  // namespace zeroset
