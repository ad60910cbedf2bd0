#pragma once

#include "engine/distance/surface_piece.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/kernel/uniforms.hpp"
#include "engine/view/box.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <vector>

namespace zeroset {

/// The function whose zeros are the surface.
struct SurfaceFunction {
    KernelFunction<RangeBatchOf<double>> range;
    /// Enclosures of its derivatives by x, y and z; where it has a kink, of all that they are
    /// nearby.
    std::array<KernelFunction<RangeBatchOf<double>>, 3> gradient;
    Uniforms uniforms;
};

/// How finely a surface is enclosed.
struct SlabLimits {
    double half_width = 0.0;             ///< of slabs, at most
    double smallest = 0.0;               ///< the diagonal of cells that are not divided
    std::size_t most_cells = 4'000'000;  ///< of one size
};

/// All zeros of a function in a box, enclosed by pieces, and how far they are from points.
class NearSurface {
public:
    /// Encloses the zeros, on all cores. The error is the number of cells that would be too many.
    static std::expected<NearSurface, std::size_t> make(const SurfaceFunction& function,
                                                        const Box& box, const SlabLimits& limits);

    [[nodiscard]] const std::vector<SurfacePiece>& pieces() const { return pieces_; }
    /// Bounds of the distance from a point to the zeros in the box: `lo` infinite where it surely
    /// holds none, `hi` where none is proved. `known`: an upper bound of the distance, if there is
    /// one. Thread-safe.
    [[nodiscard]] DistanceBounds distance(
        const glm::dvec3& point, double known = std::numeric_limits<double>::infinity()) const;

private:
    /// Some of the pieces: those of two nodes, or a few.
    struct Node {
        SurfacePiece hull;
        std::uint32_t first, count;  ///< pieces; count 0: the nodes `first` and `first` + 1
    };

    void arrange(std::uint32_t node, std::uint32_t first, std::uint32_t last);

    std::vector<SurfacePiece> pieces_;
    std::vector<Node> nodes_;  ///< the first is the root
    bool has_zero_ = false;    ///< whether a piece tells of a zero that is proved
};

}  // namespace zeroset
