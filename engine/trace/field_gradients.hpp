#pragma once

#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <glm/ext/vector_double3.hpp>

#include <array>
#include <cstdint>

namespace zeroset {

inline TileHits::Pixel place_of(std::uint32_t pixel) {
    return {.col = static_cast<std::int16_t>(pixel % tile_size),
            .row = static_cast<std::int16_t>(pixel / tile_size)};
}

/// The gradients of a frame's f at a tile's hits, from those of its field: f is the field less a
/// level, or the level less the field. Which, one evaluation of f tells.
class FieldGradients {
public:
    /// All outlive it.
    FieldGradients(const TraceFrame& frame, TileHits& hits, Counters& counters)
        : frame_(frame), hits_(hits), counters_(counters) {}

    /// Writes f's gradient at a pixel's hit, where the field has this one; false, and nothing
    /// written: it cannot be known here.
    bool put(std::uint32_t pixel, const std::array<double, 3>& position,
             const glm::dvec3& of_field);
    /// The sign of f's gradient against the field's; 0: not known yet.
    [[nodiscard]] int sign() const { return sign_; }

private:
    void find_sign(std::uint32_t pixel, const std::array<double, 3>& position,
                   const glm::dvec3& of_field);

    const TraceFrame& frame_;
    TileHits& hits_;
    Counters& counters_;
    int sign_ = 0;
};

}  // namespace zeroset
