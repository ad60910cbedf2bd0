#pragma once

#include "engine/kernel/union_parts.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/trace_frame.hpp"

#include <span>
#include <vector>

namespace zeroset {

/// The smallest box in floats that holds `box`.
ReachBox reach_box(const Box& box);
Box box_of(const ReachBox& box);

/// A union, f = min(p, q, ...), as a view shows its parts. Rays that begin where all parts
/// are above 0 have the first root of f at the first one of any part: each can be searched on its
/// own, in what it covers of the image, by code without choices.
class FrameUnion {
public:
    /// `union_parts`: of the frame's surface, in a scene whose region is whole. Both live longer.
    FrameUnion(const TraceFrame& frame, const UnionParts& union_parts);

    /// Lists the parts that may be seen in the tile, front to back; false where they cannot be
    /// searched one by one. Any thread, in upward rounding.
    bool list(const Tile& tile, std::vector<UnionMember>& members) const;

private:
    struct Member {
        UnionMember in_view;
        bool continuous;
        bool enclosed;  ///< above 0 at the faces of the clip box and at the eye
    };
    /// Whether all rays of the tile begin where all of these are above 0, and these are continuous.
    template <class Real>
    [[nodiscard]] bool are_apart(std::span<const Member* const> members, const Tile& tile) const;

    const TraceFrame& frame_;
    std::vector<Member> members_;  ///< front to back
};

}  // namespace zeroset
