#pragma once

#include "engine/kernel/form_cells.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/trace/trace_frame.hpp"
#include "papers/octree/octree_ray.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace zeroset {

/// The verdict on a leaf for its ray.
enum class LeafVerdict : std::uint8_t {
    Refused,    ///< surely without a root on the ray
    Passed,     ///< where f is not known to be continuous: the ray goes on, unsettled
    Hit,        ///< may hold a root
    Certified,  ///< the first root is in the bracket
};

/// A leaf and its ray, and what the tests say of it.
struct LeafCase {
    const OctreeRay* ray;
    Octant leaf;
    LeafVerdict verdict = LeafVerdict::Hit;
    double from = 0.0, to = 0.0;  ///< T: the bracket of a hit
};

/// The tests of leaves [Stolte05, sec. 2.5] and certificates, for some rays at once. One for each
/// thread; plain room, nothing of it set at first. All in upward rounding.
template <class Real>
class LeafTests {
public:
    static constexpr std::size_t most_leaves = 32;

    /// Judges at most most_leaves leaves before which everything on their rays is refused, in
    /// frames of the type Real. `certifies`: whether hits are to be certified where they can be.
    void judge(const TraceFrame& frame, bool certifies, std::span<LeafCase> cases,
               Counters& counters);

private:
    using Open = std::array<LeafCase*, most_leaves>;

    void evaluate(const TraceFrame& frame, std::size_t count, Counters& counters);
    /// +1 or -1 where the enclosure of box i proves a sign, else 0.
    [[nodiscard]] int sign(std::size_t i) const;

    void test_octants(const TraceFrame& frame, std::span<LeafCase* const> open, Counters& counters);
    void test_on_rays(const TraceFrame& frame, std::span<LeafCase* const> open, Counters& counters);
    /// Whether f may have both signs at the corners, of each leaf.
    void iso_value_test(const TraceFrame& frame, std::span<LeafCase* const> open,
                        std::span<bool> changes, Counters& counters);
    /// Whether some partial derivative of f may be 0, of each leaf.
    void partial_differential_test(const TraceFrame& frame, std::span<LeafCase* const> open,
                                   std::span<bool> may_vanish, Counters& counters);
    void certify(const TraceFrame& frame, std::span<LeafCase* const> open, Counters& counters);

    RangeBoxes<Real, 8 * most_leaves> boxes_;
    FormCells<Real, most_leaves> cells_;
};

extern template class LeafTests<float>;
extern template class LeafTests<double>;

}  // namespace zeroset
