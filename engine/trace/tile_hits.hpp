#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_blocks.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace zeroset {

/// The way that f goes along a ray at its root.
enum class Trend : std::int8_t { Falling = -1, Unknown = 0, Rising = 1 };

/// The kind of section that a hit is on, and so what it shows.
enum class CapKind : std::uint8_t {
    None,    ///< it is on the surface itself
    Solid,   ///< what the surface's solid is filled with
    Values,  ///< the number behind the surface
};

/// A gradient of whatever size in floats, of which the direction counts.
std::array<float, 3> float_gradient(const std::array<double, 3>& gradient);

/// Bounds for all rays of pixels, not only for those through their centres; in depths along the
/// view axis, as TileRays has them. One item a pixel, in rows of tile_size.
struct PixelCover {
    bool known = false;  ///< else nothing here says anything
    /// A bit for each block in which something is marked; no ray of a pixel in any other
    /// meets anything.
    std::uint64_t blocks = 0;
    /// A bit for each of these blocks in which sheets are not known to cover each marked pixel.
    std::uint64_t open_blocks = 0;
    /// Where one smooth sheet covers the pixel: on every ray f goes through 0 once between these.
    /// +inf: none is known.
    std::vector<float> from, to;
    /// Before this no ray meets anything but that sheet; +inf: nothing else is met in what is seen.
    std::vector<float> other_from;
    /// Behind this no ray meets anything; +inf: not known; -inf: no ray meets anything at all.
    std::vector<float> last;

    /// Nothing is marked.
    void clear();
    [[nodiscard]] bool is_marked() const { return blocks != 0; }
    [[nodiscard]] bool is_marked(std::size_t pixel) const {
        return (blocks >> block_of(pixel) & 1U) != 0;
    }
    /// Something may be marked in the block of a pixel.
    void mark(std::size_t pixel) {
        mark_covered(pixel);
        open_blocks |= std::uint64_t{1} << block_of(pixel);
    }
    /// Sheets cover the pixels of a block of which something is marked; nothing else is there.
    void mark_covered(std::size_t pixel) { blocks |= std::uint64_t{1} << block_of(pixel); }
    /// A bit for each pixel of a row, the first one lowest: whether it may show more than one
    /// smooth sheet, or less.
    [[nodiscard]] std::uint64_t mixed_in_row(int row) const;
};

/// The hits of one surface in a tile, as a tracer found them. Arrays hold one item a pixel, in rows
/// of tile_size. A pixel's ray is the one that ViewFrame::direction gives for its centre, up to
/// shifts by 2^-48 of the distances of eye and box from the origin and from each other. With the
/// rule d_stop the depth of a certified hit differs from that of the first root by at most four
/// cells along the ray's dominant axis, and 2^-21 of (depth + distance of the eye from the origin)
/// for rounding; a cell is the clip box's longest edge times 2^-d_stop, but not less than 2^-20 of
/// its largest coordinate (in double, of as many ulp).
struct TileHits {
    struct Pixel {
        std::int16_t col, row;  ///< within the tile

        [[nodiscard]] std::size_t index() const {
            return static_cast<std::size_t>(row * tile_size + col);
        }
    };
    /// A hit whose gradient is not known yet.
    struct Point {
        std::size_t pixel;
        std::array<double, 3> position;  ///< on the surface, world units
        Trend trend = Trend::Unknown;
    };

    bool any = false;  ///< whether there is a hit
    /// Distance from the eye along the ray; +inf: no hit. While a tracer works it may hold other
    /// numbers: that of beams keeps depths along the view axis in it.
    std::vector<float> depth;
    std::vector<Certificate> certificate;        ///< of hits
    std::array<std::vector<float>, 3> gradient;  ///< of f at hits, but for those among `points`
    std::vector<Point> points;
    /// Errors of `points` along rays.
    struct PointErrors {
        double bracket;  ///< how far a root may be from its point
        double depth;    ///< what rounding may make of a depth
    };
    std::optional<PointErrors> point_errors;  ///< where the tracer knows them
    /// Where rays passed a first cell that could be neither rejected nor drawn (a pole, a jump, the
    /// edge of a domain): a distance no larger than the cell's; +inf: there is none. Whether the
    /// ray hit something afterwards or not; such a hit is not certified.
    std::vector<float> unsettled;
    bool any_unsettled = false;
    /// Whether a hit is on a section: then its gradient is the section's normal.
    std::vector<CapKind> cap;
    bool any_cap = false;     ///< else `cap` is None everywhere
    bool any_values = false;  ///< else `cap` is nowhere Values
    PixelCover cover;

    [[nodiscard]] bool is_cap(std::size_t pixel) const {
        return any_cap && cap[pixel] != CapKind::None;
    }
    /// The gradient at the hit of a pixel, in rows of tile_size.
    [[nodiscard]] glm::dvec3 gradient_at(std::size_t pixel) const {
        return {gradient[0][pixel], gradient[1][pixel], gradient[2][pixel]};
    }

    TileHits();
    void clear();
    /// Adds a hit whose gradient is to be found.
    void push(Pixel at, const std::array<double, 3>& where, float distance, Certificate known);
    /// A cell on the ray, no nearer than `distance`, could be neither rejected nor drawn.
    void mark_unsettled(Pixel at, float distance);
    /// All rays of the tile are unsettled from the eye on.
    void leave_undecided(const Tile& tile);
    /// Puts a cap in place of what was found behind it.
    void put_cap(Pixel at, float distance, Certificate known, const glm::dvec3& normal,
                 CapKind kind = CapKind::Solid);
};

}  // namespace zeroset
