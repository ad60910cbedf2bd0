#pragma once

#include "engine/algebra/facts.hpp"
#include "engine/expr/expr.hpp"
#include "engine/num/enclosure.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// Where a formula is going to be evaluated.
struct SampleRegion {
    std::array<double, 3> lo{-2, -2, -2};  ///< of x, y, z
    std::array<double, 3> hi{2, 2, 2};
    std::vector<std::array<double, 2>> uniforms;  ///< ends of w and parameters; [0, 1] if absent
};

/// Boxes of all sizes as a search for the zero set of a formula meets them.
class BoxSample {
public:
    /// Descends from the region to smaller and smaller cells, into some of those that the natural
    /// interval extension of `expr` does not reject. The same for the same input. In upward
    /// rounding.
    BoxSample(const Expr& expr, std::span<const Facts> facts, const SampleRegion& region);

    /// The share of the region's finest cells that may hold a zero: about 2^-9 for a surface, 2^-18
    /// for a curve, 2^-27 for a point, some times that where enclosures are wide.
    [[nodiscard]] double share_with_zeros() const { return share_with_zeros_; }

    /// How much work a formula leaves to a search, relative to the one that the sample was made of.
    struct Work {
        double boxes;  ///< the share of boxes that have to be divided
        double width;  ///< mean width of the enclosures
    };
    /// The work on the functions that some nodes compute, on every stride-th box. In upward
    /// rounding.
    [[nodiscard]] std::vector<Work> work(const Expr& expr, std::span<const Facts> facts,
                                         std::span<const NodeId> nodes, std::size_t stride) const;

private:
    struct Cell {
        std::array<Interval<float>, 3> axes;
        std::size_t slot;     ///< which values of w and the parameters
        double weight = 0.0;  ///< boxes of a search that the cell stands for
        float width = 0.0F;   ///< of the enclosure of the formula that the sample was made of
    };
    static constexpr std::size_t slots = 8;

    /// The nodes' enclosures: of node k over cell i at k * cells.size() + i.
    [[nodiscard]] std::vector<Enclosure<float>> evaluate(const Expr& expr,
                                                         std::span<const Facts> facts,
                                                         std::span<const Cell> cells) const;
    [[nodiscard]] Interval<float> variable(const Cell& cell, int index) const;
    [[nodiscard]] std::vector<Cell> first_cells(const SampleRegion& region) const;
    [[nodiscard]] std::vector<Cell> children(std::span<const Cell> parents,
                                             std::size_t count) const;

    std::vector<std::array<double, 2>> uniforms_;
    std::vector<Cell> cells_;
    double share_with_zeros_ = 0.0;
};

}  // namespace zeroset
