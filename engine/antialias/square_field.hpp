#pragma once

#include "engine/antialias/cover_sample.hpp"
#include "engine/antialias/cover_square.hpp"
#include "engine/antialias/front.hpp"
#include "engine/antialias/half_square.hpp"
#include "engine/antialias/ray_stretches.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// The squares of a tile's mixed pixels that are searched, level by level, and last the rays that
/// stand for parts; of each the fronts of all surfaces.
class SquareField {
public:
    SquareField(const TileRays& rays, std::size_t surfaces) : rays_(rays), surfaces_(surfaces) {}

    [[nodiscard]] std::size_t size() const { return squares_.size(); }
    [[nodiscard]] const CoverSquare& square(std::size_t i) const { return squares_[i]; }
    /// The fronts of a square, one for each surface.
    [[nodiscard]] std::span<Front> fronts(std::size_t i) {
        return std::span(fronts_).subspan(i * surfaces_, surfaces_);
    }
    [[nodiscard]] const TileRays& rays() const { return rays_; }
    /// The ray through a place of a square, as TileRays counts pixels.
    [[nodiscard]] static double col_of(const CoverSquare& square, const SquareRay& place) {
        return square.pixel % tile_size + square.col_of(place);
    }
    [[nodiscard]] static double row_of(const CoverSquare& square, const SquareRay& place) {
        return static_cast<double>(square.pixel / tile_size) + square.row_of(place);
    }
    /// The width of so many pixels at a depth.
    [[nodiscard]] double width_of(double pixels, double s) const {
        return rays_.pixel() * pixels * (rays_.distance() + s);
    }
    /// The longest cell that is not halved. Thinner squares learn little from shorter cells: rays
    /// do.
    [[nodiscard]] double fair_length(const CoverSquare& square, double s) const {
        return width_of(std::max(square.side, 0.25), s);
    }
    /// The stretch of a place's ray that the front leaves open; empty outside of the clip region.
    [[nodiscard]] RayStretch stretch_of(const CoverSquare& square, const Front& front,
                                        const SquareRay& place) const;

    /// `first_roots`: the depth before which each surface surely has no root on the pixel's rays.
    void begin(const MixedPixel& pixel, std::span<const float> first_roots);
    /// Whether the hit of the pixel's own ray is the root on that ray of a front that covers all of
    /// a pixel.
    [[nodiscard]] bool shows_hit(std::size_t square, const Front& front) const;
    /// Goes on with the quarters of a square instead of it.
    void divide(std::size_t square);
    /// Goes on behind an edge of a surface with rays beside it, some of `misses`; they stand for
    /// that share of the square. `rest`: the part beside the edge; of share 0: not known.
    void add_rest(std::size_t square, std::size_t surface, const SquareRayFlags& misses,
                  double share, const SquarePart& rest);
    /// Goes on with the rays of a square instead of it.
    void divide_into_rays(std::size_t square);
    /// Goes on with the next level; false when there is none.
    bool go_down();

private:
    /// Whether at most one smooth sheet is left of what a square shows.
    [[nodiscard]] bool is_one_sheet(std::size_t square);
    /// The depth of the hit of a pixel's own ray.
    [[nodiscard]] double hit_of(const MixedPixel& pixel) const;
    /// `hit`: that depth.
    [[nodiscard]] double first_step(double hit, const Front& front) const;
    /// Begins a front, no nearer than `front.at`.
    void place(const CoverSquare& square, Front& front) const;
    /// Goes on with a part of a square, or with a ray that stands for one.
    void add_part(std::size_t square, const CoverSquare& part);

    const TileRays& rays_;
    std::size_t surfaces_;
    std::vector<CoverSquare> squares_, next_squares_, ray_squares_;
    std::vector<Front> fronts_, next_fronts_, ray_fronts_;
    std::vector<double> hits_;  ///< depths of the hits of whole pixels' own rays
};

}  // namespace zeroset
