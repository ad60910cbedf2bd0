#pragma once

#include "engine/antialias/cover_sample.hpp"
#include "engine/antialias/cover_search.hpp"
#include "engine/antialias/front.hpp"
#include "engine/antialias/half_square.hpp"
#include "engine/antialias/ray_stretches.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <span>
#include <utility>
#include <vector>

namespace zeroset {

struct SquareDepths;

/// The squares of a tile's mixed pixels that are searched, level by level, and last the rays that
/// stand for parts; of each the fronts of all surfaces.
class SquareField {
public:
    SquareField(const TileRays& rays, std::size_t surfaces)
        : rays_(rays), surfaces_(surfaces), in_(std::exchange(kept_scratch(), {})) {}
    SquareField(const SquareField&) = delete;
    ~SquareField() {
        in_.clear();
        kept_scratch() = std::move(in_);
    }

    [[nodiscard]] std::size_t size() const { return in_.squares.size(); }
    [[nodiscard]] bool is_of_one_surface() const { return surfaces_ == 1; }
    [[nodiscard]] const CoverSquare& square(std::size_t i) const { return in_.squares[i]; }
    /// The fronts of a square, one for each surface.
    [[nodiscard]] std::span<Front> fronts(std::size_t i) {
        return std::span(in_.fronts).subspan(i * surfaces_, surfaces_);
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
        return width_of(fair_side(square), s);
    }
    /// The length of the longest cell that is not halved, in pixels.
    [[nodiscard]] static double fair_side(const CoverSquare& square) {
        return std::max(square.side, 0.25);
    }
    /// The stretch of a place's ray that the front leaves open.
    [[nodiscard]] static RayStretch stretch_of(const CoverSquare& square, const Front& front,
                                               const SquareRay& place) {
        RayStretch stretch{};
        set_stretch(square, front, place, stretch);
        return stretch;
    }
    /// Sets the fields of that stretch that are not `out`.
    static void set_stretch(const CoverSquare& square, const Front& front, const SquareRay& place,
                            RayStretch& stretch) {
        stretch.col = col_of(square, place);
        stretch.row = row_of(square, place);
        stretch.from = front.at;
        stretch.to = front.to;
    }
    /// Makes room for so many pixels.
    void reserve(std::size_t pixels) {
        in_.squares.reserve(pixels);
        in_.fronts.reserve(pixels * surfaces_);
    }
    /// Adds all of a pixel to be searched; `pixel` must outlive the field.
    void add(MixedPixel& pixel);
    /// Begins the search where the squares' rays enter the clip region.
    void place_all();
    /// Whether the square is a pixel of which the own hit lies between two depths.
    [[nodiscard]] bool is_hit_between(std::size_t square, double from, double to) const {
        const CoverSquare& at = in_.squares[square];
        if (at.whole == nullptr || at.rest != nullptr) return false;
        const double spare = width_of(0.25, from);
        return from - spare <= at.hit && at.hit <= to + spare;
    }
    /// Lets the pixel's own hit stand for it.
    void leave_plain(std::size_t square) { in_.squares[square].whole->is_plain = true; }
    /// Goes on with the quarters of a square instead of it; of the rest of one, with rays.
    void divide(std::size_t square);
    /// Goes on behind an edge of a surface with what is left of the square beside it.
    void keep_rest(std::size_t square, std::size_t surface, const SquareRest& rest);
    /// Goes on with rays for a rest instead of the square, from where the stretch with the edge
    /// begins: more of the surface may be in that.
    void divide_whole_rest(std::size_t square, const SquareRest& rest);
    /// Adds the squares of which a rest was kept to `open`.
    void reopen(std::vector<std::size_t>& open);
    /// Goes on with the rays of a square instead of it.
    void divide_into_rays(std::size_t square);
    /// Goes on with the next level; false when there is none.
    bool go_down();

private:
    /// The squares of this level, those of the next, and rays, with their fronts.
    struct Scratch {
        std::vector<CoverSquare> squares, next_squares, ray_squares;
        std::vector<Front> fronts, next_fronts, ray_fronts;
        std::deque<SquareRest> rests;  ///< of the squares
        std::vector<std::size_t> reopened;

        void clear();
    };
    /// The memory of this thread's last field, for the next one.
    static Scratch& kept_scratch();

    /// Sets where the hits of whole pixels are, some squares from `first` on.
    void place_hits(std::size_t first, std::size_t count, SquareDepths& depths);
    /// Begins a front, no nearer than `front.at`, nor farther than `front.end`.
    void place(const CoverSquare& square, const DepthRange& depths, Front& front) const;
    void begin_part(const CoverSquare& square, Front& front) const;
    /// Goes on with a part of a square, or with a ray that stands for one.
    void add_part(std::size_t square, const CoverSquare& part);
    void divide_rest(std::size_t square, const SquareRest& rest);

    const TileRays& rays_;
    std::size_t surfaces_;
    Scratch in_;
};

/// Takes a surface's fronts in some squares, all of one level, on: by one cell each; or, where
/// there is only this surface, until none goes on. In upward rounding.
void advance_fronts(const TraceFrame& frame, std::size_t surface, SquareField& field,
                    std::span<const std::size_t> squares, Counters& counters);

}  // namespace zeroset
