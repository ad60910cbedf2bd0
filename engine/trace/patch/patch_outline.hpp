#pragma once

#include "engine/trace/patch/patch_leaf.hpp"
#include "engine/trace/patch/patch_sight.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace zeroset {

/// Columns of a row: up to, but not including, the last one.
struct ColumnSpan {
    int col, end_col;

    [[nodiscard]] bool empty() const { return col >= end_col; }
};

/// The form over the share of its box that a part stands for: the box is larger by form_growth. A
/// root beyond is in another part.
PatchSight without_growth(const PatchSight& sight);

/// Where on a grid of pixels a part of the patch is seen, by its linear form: within a rectangle
/// and between two pairs of parallels, the edges of the form. In upward rounding.
///
/// With (u0, v0) the ray of the part's middle, of which W = distance + s is at least `least`, and
/// any number m
///   |a - u0 W + m (b - v0 W)| = W |u - u0 + m (v - v0)|
/// has a linear form, so that |u - u0 + m (v - v0)| is at most the size of that over `least`.
class PatchOutline {
public:
    PatchOutline(const PatchSight& sight, double distance, const PixelGrid& grid);

    /// The pixels of a rectangle that may see the part.
    [[nodiscard]] TileRect within(const TileRect& rect) const;
    /// The pixels of a row of a rectangle that may see the part.
    [[nodiscard]] ColumnSpan span(int row, const TileRect& rect) const {
        const auto col = [&](const Edge& edge) { return edge.col + edge.by_row * row; };
        const double from =
            std::max({col(first_[0]), col(first_[1]), static_cast<double>(rect.col)});
        const double to = std::min({col(end_[0]), col(end_[1]), static_cast<double>(rect.end_col)});
        const double end = rect.end_col;
        return {.col = static_cast<int>(std::min(end, from)),
                .end_col = static_cast<int>(std::max(to, 0.0))};
    }

private:
    /// A column for each row.
    struct Edge {
        double col, by_row;
    };
    /// Sets the edges of the rays with |u - u0 + slope (v - v0)| <= radius.
    void set_edges(std::size_t i, double slope, double radius);

    PixelGrid grid_;
    double per_pixel_;
    bool is_known_ = false;
    double u_ = 0.0, v_ = 0.0;                ///< of the middle
    double u_radius_ = 0.0, v_radius_ = 0.0;  ///< of the rectangle
    std::array<Edge, 2> first_, end_;         ///< of spans
};

}  // namespace zeroset
