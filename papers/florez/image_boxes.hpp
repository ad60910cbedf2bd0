#pragma once

#include "engine/kernel/range_boxes.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"
#include "papers/along_rays/stretch.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// A rectangle of a tile's pixels, and what is known of the rays through their centres.
struct ImageBox {
    enum class Kind : std::uint8_t {
        Rejected,   ///< none has a root
        Included,   ///< each has one, the first between the depths `from` and `to`
        Undefined,  ///< neither is proved
    };
    int col, row;  ///< its first pixel, in the tile
    int cols, rows;
    Kind kind = Kind::Undefined;
    double from = 0.0, to = 0.0;
};

enum class BoxTests : std::uint8_t { Rejection, RejectionAndInclusion };

/// The boxes of a tile [Florez08, fig. 5.10]; see florez_boxes.cpp. Keeps its room from one tile to
/// the next. In upward rounding.
template <class Real>
class ImageBoxes {
public:
    /// The boxes that are rejected, included, or as small as they get. When the search is to end
    /// all that is left is undefined.
    const std::vector<ImageBox>& find(const TraceFrame& frame, const Tile& tile,
                                      const TileRays& rays, BoxTests tests, Counters& counters);

private:
    static constexpr std::size_t most_boxes = 64;  ///< that are looked at together
    static constexpr std::size_t most_stretches = 64;
    static constexpr std::size_t no_range = ~std::size_t{0};

    /// The end of a stretch T of a beam that waits.
    struct End {
        double at;
        EndSign sign = EndSign::NotAsked;  ///< of f on all rays of the beam
        /// Whether f is proved continuous from the nearest T on.
        bool is_continuous = false;
    };
    /// The beam through a box, on its way: before `from` there are no roots, and behind it T waits,
    /// from there to ends[count - 1], and so on.
    struct Beam {
        ImageBox box;
        double u, v, u_radius, v_radius;
        double seen_from, seen_to;  ///< between these all rays are inside what is shown
        double from;
        EndSign from_sign;
        std::size_t count;
        std::array<End, most_stretches> ends;
        std::size_t range, from_range, to_range;  ///< numbers of what was asked for
    };

    void add(const ImageBox& box);
    void ask(Beam& beam);
    [[nodiscard]] EndSign sign(std::size_t range) const;
    /// Takes F over the beam's nearest stretch.
    void take(Beam& beam);
    void finish(Beam& beam, ImageBox::Kind kind);
    [[nodiscard]] bool is_included(Beam& beam) const;
    std::size_t push(const Beam& beam, double from, double to);

    const TraceFrame* frame_ = nullptr;
    const TileRays* rays_ = nullptr;
    BoxTests tests_{};
    double margin_ = 0.0;
    double finest_ = 0.0;
    std::vector<Beam> beams_, taken_;
    std::vector<ImageBox> boxes_;
    std::size_t ranges_size_ = 0;
    RangeBoxes<Real, 3 * most_boxes> ranges_;
};

extern template class ImageBoxes<float>;
extern template class ImageBoxes<double>;

}  // namespace zeroset
