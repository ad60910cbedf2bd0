#pragma once

#include "engine/trace/tile_hits.hpp"
#include "engine/trace/tile_rays.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// -1 or 1: the sign of f inside the surface's solid. That is f < 0, unless f < 0 on most of each
/// face of the clip box: then the solid is what the rest of the box holds, f > 0. So
/// 1 = x^2 + y^2 + z^2 is filled like x^2 + y^2 + z^2 = 1. 0: it has none (SurfaceFacts::is_sheet).
int solid_sign(const Scene& scene, std::size_t surface);

/// Whether the scene has a section on which something may be seen.
bool has_caps(const Scene& scene);

/// The caps of a tile: where rays enter the region through a section and f has the sign of the
/// solid, or is defined where the section shows values, they show the section. One for each thread;
/// what it keeps is memory.
class CapFinder {
public:
    CapFinder();
    /// Finds the rays that enter through capped sections. In upward rounding, as all here.
    void enter(const TraceFrame& frame, const Tile& tile);
    /// Finds the caps of a surface on these rays, whose solid has f of this sign.
    void fill(const TraceFrame& surface, int sign, Counters& counters);
    /// Tile::limits that leave out what is behind the caps or `limits` (nullptr: none).
    const float* limits(const float* limits);
    /// Shows the caps instead of what was found of the surface. A cap is certified where the way in
    /// and the sign of f are proved, or for values that f is continuous there; where the sign is
    /// not known the ray is unsettled.
    void put(TileHits& hits) const;

private:
    enum class State : std::uint8_t { Empty, Unknown, Possible, Certain };
    struct Entry {
        std::uint16_t pixel;
        bool sure;  ///< whether the ray surely enters here
        const Section* section;
        glm::dvec3 point, radius;  ///< where f is asked for: an enclosure of the entry
        float distance, before;    ///< from the eye; the latter surely no farther
        State state = State::Empty;

        /// Takes in what is known of f around it; whether that settles the state.
        template <class Sign>
        bool settle(Sign found, int solid_sign, bool continuous);
    };

    void enter_pixel(const TileRays& rays, int col, int row);
    /// Asks for the signs of f at entries, in boxes of this type.
    template <class Real>
    void ask(const TraceFrame& surface, int sign, std::vector<Entry*>& open);

    std::vector<const Section*> sections_;  ///< through which rays of the tile may enter
    std::vector<Entry> entries_;
    std::vector<float> limits_;
};

}  // namespace zeroset
