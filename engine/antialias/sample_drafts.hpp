#pragma once

#include "engine/antialias/cover_sample.hpp"
#include "engine/antialias/cover_search.hpp"
#include "engine/antialias/front.hpp"
#include "engine/antialias/ray_stretches.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// The samples of one surface, of which some wait for their roots.
class SampleDrafts {
public:
    explicit SampleDrafts(std::uint8_t surface) : surface_(surface) {}

    /// Makes room for so many samples.
    void reserve(std::size_t samples) {
        samples_.reserve(samples);
        roots_.reserve(samples);
    }
    /// A sample that stands for a share of a square; its root lies between depths on the ray of a
    /// place.
    void add(const CoverSquare& square, const SquareRay& place, double share, double from,
             double to, Certificate certificate);
    /// A sample for what is wanted of a square, which has roots between the ends of the front.
    void add(const CoverSquare& square, const Front& front);
    /// Samples of a pixel that a sheet covers.
    void add(const MixedPixel& pixel);
    /// Samples for the parts of its least level of a square that a sheet covers.
    void add_parts(const CoverSquare& square, const Front& sheet);
    /// A sample whose root is known.
    void add(const CoverSquare& square, double share, const RayRoot& root);
    /// Finds the roots and adds the samples to `out`.
    void write(const TraceFrame& frame, const TileRays& rays, std::vector<CoverSample>& out,
               Counters& counters);

private:
    /// Begins a sample for a share of a square; its root is to be set.
    RayRoot& begin(const CoverSquare& square, double share, Certificate certificate);

    std::uint8_t surface_;
    std::vector<CoverSample> samples_;
    std::vector<RayRoot> roots_;          ///< of each sample; its bracket where it is not known
    std::vector<std::uint32_t> unknown_;  ///< the samples whose roots are not
};

}  // namespace zeroset
