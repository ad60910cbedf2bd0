#pragma once

#include "engine/trace/trace_frame.hpp"
#include "papers/octree/octree.hpp"

#include <cstdint>
#include <string_view>

namespace zeroset {

/// How rays pass octants, as ray_voxelisation.hpp has it.
enum class Traversal : std::uint8_t { Octree, Unrounded, Gargantini };

/// "octree", "octree-unrounded" or "gargantini": the tracer's name.
std::string_view name_of(Traversal traversal);

/// A traversal in double against the same octants in numbers of 128 bits.
struct TraversalCheck {
    std::uint64_t rays = 0;       ///< that meet the region
    std::uint64_t octants = 0;    ///< divided on their ways
    std::uint64_t differing = 0;  ///< of them, those of whose sub-octants others, or in another
                                  ///< order, were passed than should be
    std::uint64_t missed = 0;     ///< sub-octants that the ray passes, and the traversal left out
    std::uint64_t extra = 0;      ///< sub-octants the other way round

    TraversalCheck& operator+=(const TraversalCheck& other);
};

/// Repeats the traversals of a frame's rays in 128 bits [Stolte05, sec. 2.6], each octant on their
/// ways down to the frame's NL, until the first leaf that the enclosures of f leave: there with
/// neither of the leaf's tests. On so many threads (0: all cores). `surface`: as the tracers get
/// it; any precision.
TraversalCheck verify_traversal(const TraceFrame& surface, Traversal traversal, int threads);

}  // namespace zeroset
