#include "engine/light/lit_tile.hpp"

namespace zeroset {

LitLayer::LitLayer() {
    constexpr std::size_t pixels = static_cast<std::size_t>(tile_size) * tile_size;
    light.resize(3 * pixels);
}

void LitTile::begin(std::span<const TileHits> hits) {
    count_ = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (!hits[i].any) continue;
        if (count_ == room_.size()) room_.emplace_back();
        LitLayer& layer = room_[count_++];
        layer.surface = static_cast<std::uint8_t>(i);
        layer.hits = &hits[i];
        layer.dark_rows = {};
        layer.cover.clear();
        for (std::vector<float>& channel : layer.reflectance)
            channel.clear();
    }
}

}  // namespace zeroset
