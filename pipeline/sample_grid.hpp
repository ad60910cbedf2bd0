#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/kernel/uniforms.hpp"
#include "engine/view/box.hpp"
#include "engine/volume/geometry.hpp"
#include "engine/volume/samples.hpp"
#include "pipeline/input_error.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace zeroset {

/// A grid whose outermost samples lie on the box's faces.
struct GridPlan {
    Box box;
    GridSize size{};  ///< at least two along each axis
};

/// Where the samples of the plan lie.
Geometry geometry_of(const GridPlan& plan);

/// The coordinate along an axis of a plan's samples with this index.
double sample_place(const Geometry& geometry, std::size_t axis, std::size_t index);

/// f at the samples of a plan, row by row along x: computed in double, rounded to the nearest
/// float32, NaN where it is not defined. Large grids take machine code where it can be made. Once
/// made it can be asked by any thread.
class GridFunction {
public:
    /// `uniforms`: w and the parameters, in the graph's order.
    GridFunction(const Expr& f, const Uniforms& uniforms, const GridPlan& plan);

    [[nodiscard]] std::size_t width() const { return width_; }
    [[nodiscard]] std::size_t rows() const { return rows_; }
    /// Rows that are best asked at once: as many as fit a processor's cache, or all.
    [[nodiscard]] std::size_t rows_at_once() const;
    /// The samples of so many rows, from row y + ny z on: `width` numbers each.
    void sample(std::size_t first_row, std::span<float> samples) const;

private:
    using Column = std::vector<double>;

    [[nodiscard]] Column along(std::size_t axis) const;
    [[nodiscard]] std::vector<Column> row_values(std::size_t first_row, std::size_t count) const;

    GridPlan plan_;
    Geometry geometry_;
    std::size_t width_ = 0;
    std::size_t rows_ = 0;
    std::vector<double> uniforms_;
    PointFunction function_;             ///< of what is left for each point
    std::vector<Column> tables_;         ///< three, `width` numbers each, padded
    std::vector<PointFunction> of_row_;  ///< functions of y and z
};

/// Calls `take` with the samples of all rows in their order, some rows at a time; they are computed
/// on all cores meanwhile. False, and an early end, once `take` returns false.
bool sample_in_order(const GridFunction& function,
                     const std::function<bool(std::span<const float>)>& take);

/// The samples in memory, computed on all cores.
Samples sampled(const Expr& f, const Uniforms& uniforms, const GridPlan& plan);

/// Signed distances at the samples of a grid.
struct DistanceGrid {
    Samples samples;             ///< as float32; below 0 where f is
    std::uint64_t unproved = 0;  ///< samples that may be off by more than the tolerance
    double worst = 0;            ///< by how much those may be off; infinite: not known
};

/// The distance from each sample of the plan to the nearest zero of f, wherever that lies, negative
/// where f < 0 there and NaN where f is not defined. It is off by at most `tolerance`, which is
/// proved by enclosures of f, but for `unproved` samples: there it is the least that it may be, as
/// no zero is proved to be near enough. On all cores. An error where the box surely has no zero,
/// and where f's zeros take too many cells to enclose.
OrInputError<DistanceGrid> sampled_distance(const Expr& f, const Uniforms& uniforms,
                                            const GridPlan& plan, double tolerance);

}  // namespace zeroset
