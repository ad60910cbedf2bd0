// Proves whole pixels covered or free, a bin of pixels at once: for those whose rays have hits,
// whether one sheet about the hit covers the pixel and nothing is before it; for others, whether
// all of their rays miss. Pixels for which a few cells do not prove that are left to a closer
// search.

#include "engine/real/scalar.hpp"
#include "engine/trace/blobs/ball_bins.hpp"
#include "engine/trace/blobs/ball_sums.hpp"
#include "engine/trace/blobs/blob_kernel.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace zeroset {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();
/// A pixel in which normal . view may change by more shows more than one colour.
constexpr double most_turn = 0.5;
/// Sheets that need more depth, in pixels' widths, are seen from the side.
constexpr double most_depth = 6;
/// The most cells that are looked at for each pixel before its sheet.
constexpr int most_cells = 12;
/// The shortest cell that is tried, in pixels' widths.
constexpr double least_cell = 0.25;

/// The share of the way to a pixel's end that is tried at once.
constexpr double first_part = 0.6;

static_assert(BallBins::side * BallBins::side == most_ball_lanes);

/// A pixel of a bin, and what is known of it.
struct Pixel {
    std::size_t at;  ///< in the tile
    double u, v;
    DepthRange inside;
    double first;         ///< no ball reaches its rays before
    double from, to;      ///< of the sheet; from +inf: none is known
    double free_to, end;  ///< nothing is met before free_to, which shall come to end
    double step;
};

class BlobCover {
public:
    BlobCover(const TraceFrame& frame, const BlobSurface& surface, BallBins& bins)
        : frame_(frame),
          bins_(bins),
          rays_(bins.rays()),
          forms_(ball_forms(bins, surface)),
          half_((0.5 + 0x1p-20) * rays_.pixel()) {
        cells_.u_radius = cells_.v_radius = half_;
    }

    void mark(const Tile& tile, TileHits& hits) {
        hits.cover.clear();
        for (int row = 0; row < tile.rows; row += BallBins::side) {
            for (int col = 0; col < tile.cols; col += BallBins::side) {
                index_ = BallBins::index_of(col, row);
                list(tile, col, row);
                if (count_ == 0) continue;
                find_sheets(hits);
                search();
                write(hits);
            }
        }
    }

private:
    /// Lists the bin's pixels that balls may reach.
    void list(const Tile& tile, int first_col, int first_row) {
        count_ = 0;
        for (int row = first_row; row < std::min(first_row + BallBins::side, tile.rows); ++row) {
            for (int col = first_col; col < std::min(first_col + BallBins::side, tile.cols);
                 ++col) {
                const double first = bins_.first_depth(col, row);
                if (first == none) continue;
                Pixel& pixel = pixels_[count_++];
                pixel.at = static_cast<std::size_t>(row * tile_size + col);
                pixel.u = rays_.u(col);
                pixel.v = rays_.v(row);
                pixel.inside = rays_.depths(pixel.u, pixel.v, half_, half_);
                pixel.first = std::max(first, pixel.inside.enter_lo);
                pixel.free_to = pixel.first;
                pixel.from = pixel.to = none;
            }
        }
    }
    [[nodiscard]] double pixel_at(double s) const { return rays_.pixel() * (rays_.distance() + s); }
    void ask(std::size_t lane, const Pixel& pixel, double from, double to) {
        cells_.u[lane] = pixel.u;
        cells_.v[lane] = pixel.v;
        cells_.s[lane] = 0.5 * from + 0.5 * to;
        cells_.s_radius[lane] = std::max(to - cells_.s[lane], cells_.s[lane] - from);
    }
    void answer(std::size_t count) {
        cells_.count = count;
        double until = bins_.from();
        for (std::size_t i = 0; i < count; ++i)
            until = std::max(until, cells_.s[i] + cells_.s_radius[i]);
        const BallBin& bin = bins_.bin(index_, until);
        if (frame_.precision == Precision::Double) {
            forms_by_doubles(forms_, bin, cells_, answers_.data());
        } else {
            forms_by_floats(forms_, bin, cells_, answers_.data());
        }
    }

    /// Looks for sheets that cover pixels about the hits of their own rays.
    void find_sheets(const TileHits& hits) {
        std::size_t asked = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            Pixel& pixel = pixels_[i];
            const auto distance = static_cast<double>(hits.depth[pixel.at]);
            // Require all of a ray without a hit to be free.
            pixel.end = distance < none ? -none : pixel.inside.exit_hi;
            if (!(distance < none)) continue;
            const double s = distance / std::sqrt(1.0 + pixel.u * pixel.u + pixel.v * pixel.v) -
                             rays_.look_distance();
            const double reach = reach_of(pixel, s, hits.gradient_at(pixel.at));
            if (!(s - reach >= pixel.inside.enter_hi && s + reach <= pixel.inside.exit_lo))
                continue;
            ask(asked, pixel, s - reach, s + reach);
            of_[asked++] = i;
        }
        if (asked == 0) return;
        answer(asked);
        for (std::size_t k = 0; k < asked; ++k)
            take_sheet(pixels_[of_[k]], k);
    }
    /// How far before and behind its hit a pixel's sheet is looked for; +inf: too far.
    [[nodiscard]] double reach_of(const Pixel& pixel, double s, const glm::dvec3& gradient) const {
        const ViewFrame& view = rays_.axes();
        const glm::dvec3 along = view.forward + pixel.u * view.right + pixel.v * view.up;
        const double across =
            std::abs(glm::dot(gradient, view.right)) + std::abs(glm::dot(gradient, view.up));
        const double width = pixel_at(s);
        const double depth = 0.5 * width * across / std::abs(glm::dot(gradient, along));
        return depth < most_depth * width ? 1.25 * depth + 0.25 * width : none;
    }
    void take_sheet(Pixel& pixel, std::size_t lane) const {
        const BallForm& form = answers_[lane];
        const double s = cells_.s[lane];
        const double reach = cells_.s_radius[lane];
        const bool monotone = form.slope_lo > 0 || form.slope_hi < 0;
        const double aside = std::abs(form.along[0]) + std::abs(form.along[1]);
        const double steepness = std::abs(form.along[2]);
        const double spread = (1 + 0x1p-40) * (aside + form.error);
        // Where the linear part is 0, all roots are near: within the cell.
        if (!monotone || !(std::abs(form.c) + spread < (1 - 0x1p-20) * steepness)) return;
        const double steepest = std::max(aside / (0.5 * pixel_at(s)), steepness / reach);
        if (!(form.slope_hi - form.slope_lo <= most_turn * steepest)) return;
        const double middle = -form.c / form.along[2];
        const double part = spread / steepness + 0x1p-30;
        pixel.from = s + reach * (middle - part);
        pixel.to = s + reach * (middle + part);
        // The cell before the roots is free.
        pixel.end = s - reach;
    }

    /// Goes on to the pixels' ends as far as cells are rejected.
    void search() {
        for (std::size_t i = 0; i < count_; ++i)
            pixels_[i].step = first_part * (pixels_[i].end - pixels_[i].free_to);
        for (int tries = 0; tries < most_cells; ++tries) {
            std::size_t asked = 0;
            for (std::size_t i = 0; i < count_; ++i) {
                const Pixel& pixel = pixels_[i];
                if (!(pixel.free_to < pixel.end) ||
                    !(pixel.step >= least_cell * pixel_at(pixel.free_to)))
                    continue;
                ask(asked, pixel, pixel.free_to, std::min(pixel.free_to + pixel.step, pixel.end));
                of_[asked++] = i;
            }
            if (asked == 0) return;
            answer(asked);
            for (std::size_t k = 0; k < asked; ++k)
                take_step(pixels_[of_[k]], answers_[k]);
        }
    }
    static void take_step(Pixel& pixel, const BallForm& form) {
        const double most = (1 + 0x1p-40) * (std::abs(form.along[0]) + std::abs(form.along[1]) +
                                             std::abs(form.along[2]) + form.error);
        const double size = std::abs(form.c);
        const double end = std::min(pixel.free_to + pixel.step, pixel.end);
        const double length = end - pixel.free_to;
        if (size > most) {
            pixel.free_to = end;
            pixel.step = std::max(std::clamp(size / most, 1.0, 4.0) * length,
                                  first_part * (pixel.end - end));
        } else {
            pixel.step = std::clamp(std::sqrt(size / most), 0.125, 0.5) * length;
        }
    }

    void write(TileHits& hits) const {
        PixelCover& cover = hits.cover;
        for (std::size_t i = 0; i < count_; ++i) {
            const Pixel& pixel = pixels_[i];
            const bool is_free = pixel.end > -none && pixel.free_to >= pixel.end;
            const bool is_covered = is_free && pixel.from < none;
            if (is_free && !is_covered) continue;
            cover.mark(pixel.at);
            cover.last[pixel.at] = std::numeric_limits<float>::infinity();
            if (is_covered) {
                cover.from[pixel.at] = -float_above(-pixel.from);
                cover.to[pixel.at] = float_above(pixel.to);
            } else {
                cover.other_from[pixel.at] = -float_above(-pixel.free_to);
            }
        }
    }

    const TraceFrame& frame_;
    BallBins& bins_;
    const TileRays& rays_;
    BallForms forms_;
    double half_;
    std::size_t index_ = 0, count_ = 0;
    std::array<Pixel, most_ball_lanes> pixels_{};
    BallCells cells_{};
    std::array<BallForm, most_ball_lanes> answers_{};
    std::array<std::size_t, most_ball_lanes> of_{};  ///< the pixels that are asked about
};

}  // namespace

void mark_blob_cover(const TraceFrame& frame, const Tile& tile, const BlobSurface& surface,
                     TileHits& hits) {
    BallBins& bins = thread_ball_bins();
    bins.begin(frame, tile, surface);
    BlobCover(frame, surface, bins).mark(tile, hits);
}

}  // namespace zeroset
