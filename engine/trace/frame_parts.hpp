#pragma once

#include "engine/kernel/least_of.hpp"
#include "engine/trace/tracer.hpp"

#include <span>
#include <vector>

namespace zeroset {

/// The parts of a union, f = min(p, q, ...), as a view shows them. Rays that begin where all parts
/// are above 0 have the first root of f at the first one of any part: each can be searched on its
/// own, in what it covers of the image, by code without choices.
class FrameParts {
public:
    /// Of the frame's surface, in a scene whose region is whole. Both live longer.
    FrameParts(const TraceFrame& frame, const LeastOf& least_of);

    /// Those that may be seen in the tile, front to back; false where they cannot be searched one
    /// by one. Any thread, in upward rounding.
    bool list(const Tile& tile, std::vector<PartInView>& parts) const;

private:
    struct Part {
        PartInView in_view;
        bool continuous;
        bool whole;  ///< above 0 at the faces of the clip box and at the eye
    };
    /// Whether all rays of the tile begin where all of these are above 0, and these are continuous.
    template <class Real>
    [[nodiscard]] bool are_apart(std::span<const Part* const> parts, const Tile& tile) const;

    const TraceFrame& frame_;
    std::vector<Part> parts_;  ///< front to back
};

}  // namespace zeroset
