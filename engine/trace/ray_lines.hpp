#pragma once

#include "engine/trace/tile.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// The ray of a pixel: the point at depth s is origin + s direction.
struct RayLine {
    std::array<double, 3> origin, direction;
    DepthRange inside;  ///< where it is inside the clip box and the region
    double from, to;    ///< where roots are looked for: not beyond the tile's limit by much
    double per_size;    ///< change of s for a step of 1 along the ray's dominant axis
    std::uint8_t axis;  ///< the dominant one

    [[nodiscard]] std::array<double, 3> at(double s) const {
        std::array<double, 3> point{};
        for (std::size_t k = 0; k < 3; ++k)
            point[k] = origin[k] + s * direction[k];
        return point;
    }
};

/// The rays of a tile on which something may be seen.
class RayLines {
public:
    /// Keeps its memory from one tile to the next. `digits`: of the type in which f is enclosed.
    void begin(const TraceFrame& frame, const Tile& tile, const TileRays& rays, int digits);

    /// In place of that, for rays that are taken one by one.
    void begin_singly(const TraceFrame& frame, int digits);
    /// Makes the ray of a pixel; whether something may be seen on it.
    bool take(const Tile& tile, const TileRays& rays, int col, int row);

    /// The pixels whose rays are inside the clip box and the region somewhere.
    [[nodiscard]] const std::vector<std::uint32_t>& pixels() const { return pixels_; }
    [[nodiscard]] const RayLine& of(std::uint32_t pixel) const { return lines_[pixel]; }
    /// Keeps the rays for which `keep(pixel, line)` is true; it may narrow where roots are looked
    /// for.
    template <class Keep>
    void keep_if(const Keep& keep) {
        std::erase_if(pixels_, [&](std::uint32_t pixel) { return !keep(pixel, lines_[pixel]); });
    }
    /// The width of the finest stretches at depth s on a ray: cells as in SearchDepth, or the
    /// value of the rule epsilon, but not below a few ulp of the type.
    [[nodiscard]] double finest(const RayLine& line, double s) const;
    /// No more than `finest` on any ray of some pixels from the tile's (col, row) on, at depth s or
    /// farther; 0: brackets of that do not certify on all of them.
    [[nodiscard]] double least_finest(const TileRays& rays, double cols, double rows,
                                      double s) const;
    /// Whether brackets of some finest stretches are narrow enough to certify a root.
    [[nodiscard]] bool certifies(const RayLine& line) const { return certifies_[line.axis]; }

private:
    void set_cells(const TraceFrame& frame, int digits);
    std::vector<RayLine> lines_;  ///< in rows of tile_size
    std::vector<std::uint32_t> pixels_;
    double epsilon_ = 0.0;          ///< of the rule epsilon; 0: another one
    std::array<double, 3> cell_{};  ///< the finest, of rays along each axis, world units
    std::array<bool, 3> certifies_{};
    bool grows_ = false;  ///< cells grow with their distance from the eye
    double look_distance_ = 0.0;
    double growth_ = 0.0;       ///< a cell for each unit of that distance
    double most_growth_ = 1.0;  ///< the widest cell, in finest ones
};

}  // namespace zeroset
