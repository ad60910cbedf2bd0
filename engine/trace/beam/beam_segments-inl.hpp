// Parts of rays that are searched on their own (beam_rays-inl.hpp).
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_SEGMENTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_SEGMENTS_INL
#undef ZEROSET_BEAM_SEGMENTS_INL
#else
#define ZEROSET_BEAM_SEGMENTS_INL
#endif

#include "engine/trace/beam/beam_pieces-inl.hpp"
#include "engine/trace/beam/beam_ranges-inl.hpp"
#include "engine/trace/beam/beam_verdicts-inl.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A part of a ray still to be searched, from the front.
template <class Real>
struct RaySegment {
    std::uint32_t pixel;
    bool inside;  ///< surely inside the clip box
    Real from, to;
    Real step;             ///< how far the next cell reaches
    const Kernel* kernel;  ///< of f on it

    [[nodiscard]] Real end() const { return std::min(to, from + step); }
    /// From `begin` to `last` on the same ray, with a first cell of `first_step`.
    [[nodiscard]] RaySegment part(Real begin, Real last, Real first_step) const {
        return {.pixel = pixel,
                .inside = inside,
                .from = begin,
                .to = last,
                .step = first_step,
                .kernel = kernel};
    }
};

/// Where a march ends.
template <class Real>
struct MarchSettings {
    Real finest;     ///< segments are not made shorter
    Real margin;     ///< cells are longer than their part of the ray by this at both ends
    bool certifies;  ///< brackets of some `finest` are narrow enough to certify a root
    Real asked = 0;  ///< the width of brackets that is asked for; not below `finest`
};

/// A part of a segment, as short as parts get, in which there may be a root.
template <class Real>
struct LeftoverSegment {
    RaySegment<Real> segment;
    Real from, to;  ///< where the root may be
    bool continuous;
};

/// Memory that a RayMarcher keeps; empty between marches.
template <class Real>
struct MarchMemory {
    static constexpr std::size_t capacity = 256;
    /// Switches that are held at a time, and pieces of a cell at most.
    static constexpr int most_switches = 3;
    static constexpr std::size_t most_pieces = 27;

    std::vector<RaySegment<Real>> segments;
    std::vector<RaySegment<Real>> next;            ///< those that go on after this round
    std::vector<LeftoverSegment<Real>> leftovers;  ///< of the batch at work
    std::vector<std::size_t> asked;
    RangeMemory<Real> ranges, witness_ranges;
    SegmentCells<Real> cells{capacity};
    Pieces<Real> pieces;
    /// Made when first wanted, as few functions have pieces.
    std::unique_ptr<SegmentCells<Real>> piece_cells;
    /// Where a root may be in some piece of each cell; empty where from > to.
    std::vector<Real> left_from, left_to;

    SegmentCells<Real>& cells_of_pieces() {
        if (piece_cells == nullptr)
            piece_cells = std::make_unique<SegmentCells<Real>>(most_pieces * capacity);
        return *piece_cells;
    }
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
