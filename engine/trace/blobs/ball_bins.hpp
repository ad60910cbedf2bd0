#pragma once

#include "engine/trace/blobs/blob_surface.hpp"
#include "engine/trace/blobs/near_balls.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace zeroset {

/// Balls as columns in one type, those whose from() is least first: x and y from where the middle
/// ray of the bin is at their depth, z from `BallBin::depth`.
template <class Real>
struct BinColumns {
    std::vector<Real> x, y, z, per_square, strength;
};

/// The balls that may reach the rays of some pixels close to each other.
struct BallBin {
    double u = 0, v = 0;      ///< the middle ray
    double depth = 0;         ///< that is 0 in the columns
    double most_support = 0;  ///< of any ball
    BinColumns<float> floats;
    BinColumns<double> doubles;
    std::size_t count = 0;
    std::vector<float> from, to;  ///< the depths between which a ball reaches, from `depth` on

    template <class Real>
    [[nodiscard]] const BinColumns<Real>& columns() const {
        if constexpr (sizeof(Real) == sizeof(float)) {
            return floats;
        } else {
            return doubles;
        }
    }
};

/// The balls near the rays of a tile's whole pixels, in bins of a few pixels; found as far along
/// the view as somebody asks.
class BallBins {
public:
    /// Pixels across a bin, and how much farther its rays may be than its pixels reach.
    static constexpr int side = 4;
    static constexpr double margin = 1.0 / 16;
    static constexpr std::size_t across = tile_size / side;

    /// All outlive it.
    void begin(const TraceFrame& frame, const Tile& tile, const BlobSurface& surface);

    [[nodiscard]] const TileRays& rays() const { return *rays_; }
    /// The depths between which balls are found.
    [[nodiscard]] double from() const { return from_; }
    [[nodiscard]] double to() const { return to_; }
    /// Where rays pass the image, as TileRays counts pixels.
    [[nodiscard]] double col(double u) const { return (u - first_u_) * per_pixel_; }
    [[nodiscard]] double row(double v) const { return (first_v_ - v) * per_pixel_; }

    /// The index of the bin of the pixel in which a ray is.
    [[nodiscard]] static std::size_t index_of(double col, double row) {
        return place_of(row) * across + place_of(col);
    }
    /// The bin with all balls that may reach its rays before a depth. Until the next call.
    [[nodiscard]] const BallBin& bin(std::size_t index, double until);
    /// Whether rays within so many pixels of this one are among those of the bin.
    [[nodiscard]] static bool holds(double col, double row, double radius) {
        return off_middle(col) + radius <= 0.5 * side + margin &&
               off_middle(row) + radius <= 0.5 * side + margin;
    }
    /// Before this depth no ball reaches any ray of a pixel of the tile; +inf: none does.
    [[nodiscard]] double first_depth(int col, int row);

private:
    struct Listed {
        std::vector<std::uint32_t> balls;
        std::size_t packed = 0;  ///< how many of them are in the columns
        BallBin bin;
    };

    [[nodiscard]] static std::size_t place_of(double pixel) {
        // std::max in this order gives 0 for NaN, so that each place has a bin.
        const double at = std::min(std::max(0.0, (pixel + 0.5) / side), across - 1.0);
        return static_cast<std::size_t>(static_cast<int>(at));
    }
    [[nodiscard]] static double off_middle(double pixel) {
        return std::abs(pixel - middle_of(place_of(pixel)));
    }
    [[nodiscard]] static double middle_of(std::size_t place) {
        return static_cast<double>(place) * side + 0.5 * (side - 1);
    }
    bool find_more();
    void put(std::uint32_t number);
    void pack(Listed& listed, std::size_t col, std::size_t row);
    [[nodiscard]] bool may_reach(const ViewBall& ball, int col, int row) const;

    std::optional<TileRays> rays_;
    double from_ = 0, to_ = 0;
    double first_u_ = 0, first_v_ = 0, per_pixel_ = 0;
    double longest_ = 0;  ///< of the directions
    NearBalls near_;
    double found_to_ = 0;
    std::vector<ViewBall> balls_;
    std::array<Listed, across * across> bins_;
};

/// The bins of this thread's last tile.
BallBins& thread_ball_bins();

}  // namespace zeroset
