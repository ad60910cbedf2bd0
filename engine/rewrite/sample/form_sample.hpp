#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/form_cells.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/rewrite/sample/box_sample.hpp"

#include <array>
#include <vector>

namespace zeroset {

/// Cells of all sizes as the beam tracer meets them on its search for the zero set of a formula,
/// in a view that is along no axis.
class FormSample {
public:
    /// Descends into some of those cells of the region that the form of `expr` does not reject.
    /// The sample depends on its input alone.
    FormSample(const Expr& expr, const SampleRegion& region);

    /// The mean share of the cells' depths, 0 to 1, in which the form leaves room for zeros.
    [[nodiscard]] double open() const { return open_; }
    /// The share for the function, of the same parameters, written in another way.
    [[nodiscard]] double open(const Expr& expr) const;
    /// How many steps of the formula's interpreter are left in the mean in one of the smallest
    /// cells, where what does not matter there is left out.
    [[nodiscard]] double steps_left(const Kernel& kernel) const;

private:
    static constexpr std::size_t cells_a_level = 64;
    /// To the right, up and forward of the region's middle.
    using Place = std::array<double, 3>;
    /// Cells of one size, cubes about the places; a multiple of batch_multiple.
    struct Level {
        double half;  ///< of an edge
        std::vector<Place> cells;
    };

    void place(const Level& level, FormCells<float, cells_a_level>& cells) const;
    /// The share of each cell's depth that is left open.
    [[nodiscard]] std::vector<double> shares(const Kernel& kernel, const Level& level) const;

    [[nodiscard]] double cells() const;

    std::array<double, 3> middle_{};
    double half_ = 0;  ///< of the longest edge
    Uniforms uniforms_;
    std::vector<Level> levels_;
    double open_ = 0;
};

}  // namespace zeroset
