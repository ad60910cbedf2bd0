#pragma once

#include "engine/volume/pyramid.hpp"
#include "engine/volume/samples.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace zeroset {

/// How many samples lie in each of equal parts of their range.
struct Histogram {
    double first = 0.0;  ///< the lower end of the first part
    double width = 1.0;  ///< of a part, above 0
    std::vector<std::uint64_t> counts;

    bool operator==(const Histogram&) const = default;
};

/// Counts all samples that are finite numbers, on all cores, in at most `most` parts (above 0).
/// Parts of whole numbers have whole widths, so that each holds as many values as any other.
/// `range`: of the samples. Returns nothing where there is no such sample, or when `stop` was set
/// meanwhile.
std::optional<Histogram> histogram_of(const Samples& samples, const SampleRange& range,
                                      std::size_t most, const std::atomic<bool>& stop);

/// The histogram_of some of the samples, equally many from each of a few slices, so that little of
/// a file is read.
std::optional<Histogram> quick_histogram(const Samples& samples, const SampleRange& range,
                                         std::size_t most);

/// The value that divides the samples best into two kinds: of which the means are farthest apart
/// for how many samples both have [Otsu79].
double dividing_value(const Histogram& histogram);

}  // namespace zeroset
