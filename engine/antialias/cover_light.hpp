#pragma once

#include "engine/antialias/cover_sample.hpp"
#include "engine/antialias/seen_sheet.hpp"
#include "engine/appearance/frame_light.hpp"
#include "engine/light/encode.hpp"
#include "engine/light/lit_tile.hpp"
#include "engine/trace/trace_frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// Linear light, red, green and blue; and how much of what is seen is not the background.
using CoverColor = std::array<float, 4>;

/// Memory for lighting samples; one for each thread.
class CoverLight {
public:
    /// The light that each sample's hit sends to the eye. `layers`: the tile's own hits, lit. Ends
    /// early when the limit is over: then some of it is undefined. In upward rounding.
    std::span<const CoverColor> light(const FrameLight& frame_light,
                                      std::span<const TraceFrame> surfaces, const TimeLimit& limit,
                                      const Tile& tile, std::span<const LitLayer> layers,
                                      std::span<const CoverSample> samples, Counters& counters);

private:
    void put(const CoverSample& sample, std::size_t slot);
    /// Takes what the tile's hits tell of a sample's shadow.
    void take_shadow(SampleShadow shadow, std::size_t slot);
    /// A sample, in an order in which those that are near each other follow each other.
    struct NearSample {
        std::uint64_t nearness;
        std::size_t sample;
    };
    /// Takes the light of these samples, of which item k has the slot k.
    void take(std::span<const NearSample> some);
    /// Takes their hits away again.
    void forget(std::span<const CoverSample> samples, std::span<const NearSample> some);

    std::vector<NearSample> by_nearness_;
    std::vector<float> cols_, rows_;
    std::vector<std::uint8_t> surface_of_slot_;
    std::vector<TileHits> hits_;
    KnownShadows known_;
    LitTile lit_;
    std::vector<CoverColor> light_;
};

/// Draws pixels of a tile again: the light of their samples by area, before the background. Their
/// alpha is the area of all samples as far as the background is not seen, or 255 where there is
/// none.
void draw_cover(const Tile& tile, std::span<const MixedPixel> pixels,
                std::span<const CoverSample> samples, std::span<const CoverColor> light,
                const Canvas& out);

}  // namespace zeroset
