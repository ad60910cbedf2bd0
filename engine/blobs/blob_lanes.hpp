#pragma once

#include "engine/blobs/blob_kind.hpp"
#include "engine/blobs/blob_set.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

// Sums over blobs for many points and boxes at once, in the machine's widest vectors. Arrays hold a
// number for each lane; those beyond `count` mean nothing. A blob that does not reach a lane adds 0
// to it, so lanes are answered alike among whatever others; sums and their order are the same on
// every machine, without fused operations. In any rounding mode.

namespace zeroset {

/// The most lanes at once.
inline constexpr std::size_t most_blob_lanes = 16;
using BlobNumbers = double[most_blob_lanes];

struct BlobPoints {
    alignas(64) BlobNumbers at[3];
    BlobNumbers value, slope[3];
    std::size_t count;
};

struct BlobBoxes {
    alignas(64) BlobNumbers lo[3];
    BlobNumbers hi[3];
    BlobNumbers value_lo, value_hi;
    BlobNumbers slope_lo[3], slope_hi[3];
    // The number of blobs that reach the box, and their sums of |s| and of |s|/r.
    BlobNumbers reached, size, size_per_radius;
    std::size_t count;
};

/// Blobs of a set: numbers `first` up to before `last`.
struct BlobRange {
    std::uint32_t first, last;
};
struct BlobRun {
    const BlobSet& set;
    BlobKind kind;
    std::span<const BlobRange> ranges;
};
/// Adds the blobs' values and slopes.
void add_blobs(const BlobRun& run, BlobPoints& points);
/// Adds the ranges of the blobs' values and slopes, but for roundings.
void add_blobs(const BlobRun& run, BlobBoxes& boxes);

}  // namespace zeroset
