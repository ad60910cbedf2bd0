#pragma once

#include <cstdint>
#include <string_view>

// The heights of soft balls. A ball of radius r about c with the strength s adds s h(q) to its
// field, for q = |p - c|^2 / r^2. Each h falls from the middle on, is convex in q, and h(1) = 1: a
// ball alone is a ball of radius r where the field is 1.
//
//   Wyvill    2 - 11/9 q + 17/72 q^2 - 1/72 q^3 up to q = 4, then 0 [Wyvill86]
//   Metaball  8/3 - 2 q up to q = 4/9, (2 - sqrt(q))^2 up to q = 4, then 0 [Nishimura85]
//   Blinn     exp(2 (1 - q)) [Blinn82]
//
// The first two have local support, twice the radius. That of Blinn's is what reaches into the
// digits of doubles: beyond q = 26 it is below 2^-72.

namespace zeroset {

enum class BlobKind : std::uint8_t { Wyvill, Metaball, Blinn };

/// The word that a text has for them.
constexpr std::string_view blob_name(BlobKind kind) {
    return kind == BlobKind::Wyvill ? "blobs" : kind == BlobKind::Metaball ? "metaballs" : "blinn";
}

struct BlobFacts {
    double reach;  ///< the q up to which balls are counted
    double top;    ///< h(0), or above it
    double slope;  ///< bounds 2 sqrt(q) |h'(q)|, which is r times the slope
    double bend;   ///< bounds 2 |h'(q)| + 4 q |h''(q)|, which is r^2 times second derivatives
    double tail;   ///< bounds h, and r times the slope, beyond the reach
};
constexpr BlobFacts blob_facts(BlobKind kind) {
    switch (kind) {
        // 2 sqrt(q) |h'| is 1.577 at q = 0.9 at most, 2 |h'| + 4 q |h''| below its parts' maxima.
        case BlobKind::Wyvill: return {.reach = 4, .top = 2, .slope = 1.6, .bend = 5, .tail = 0};
        case BlobKind::Metaball:
            return {.reach = 4, .top = 8.0 / 3 + 1e-15, .slope = 2.7, .bend = 10.1, .tail = 0};
        // 4 sqrt(q) h is largest at q = 1/4; 4 h + 16 q h at q = 1/4.
        case BlobKind::Blinn: break;
    }
    return {.reach = 26, .top = 7.3890560989306505, .slope = 9, .bend = 36, .tail = 0x1p-67};
}

}  // namespace zeroset
