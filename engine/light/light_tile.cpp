#include "engine/light/light_tile.hpp"

#include "engine/light/shade.hpp"
#include "engine/light/shadow.hpp"
#include "engine/light/tile_colors.hpp"

namespace zeroset {

void light_tile(std::span<const TraceFrame> surfaces, bool shadows, const TimeLimit& limit,
                const Tile& tile, std::span<const TileHits> hits, LitTile& out,
                Counters& counters) {
    out.begin(hits);
    if (shadows) find_shadows(surfaces, limit, tile, out.layers(), counters);
    for (LitLayer& layer : out.layers()) {
        find_colors(surfaces[layer.surface], tile, layer, counters);
        shade(surfaces[layer.surface], tile, layer);
    }
}

}  // namespace zeroset
