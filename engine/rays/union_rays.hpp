#pragma once

#include "engine/kernel/union_parts.hpp"
#include "engine/trace/scene_ray.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace zeroset {

/// A surface that is a union, f = min(p, q, ...), as single rays meet its parts: from where all of
/// these are 0 or above, the first root of f is the first one of any part, and only parts that are
/// on a ray's way need to be searched. Of any other surface it knows nothing.
class UnionRays {
public:
    /// For rays that are all within the clip box; those of `rays` and what they pass.
    UnionRays(const TraceFrame& surface, std::uint8_t number, std::span<const SceneRay> rays);

    /// A part of a ray on which a part of the union may have roots.
    struct Meeting {
        const Kernel* kernel;
        SceneRay stretch;
        bool at_start;  ///< it holds the ray's beginning
    };
    /// Lists the parts that a ray meets; false where the whole surface is to be searched instead.
    bool list(const SceneRay& ray, std::vector<Meeting>& meetings) const;

private:
    struct Member {
        const Kernel* kernel;
        Box box;
    };
    [[nodiscard]] bool begins_outside(const SceneRay& ray) const;

    std::uint8_t number_;
    double spare_ = 0.0;  ///< boxes are so much wider than where parts are
    bool known_ = false;
    std::shared_ptr<const std::vector<Reach>> reaches_;
    std::vector<Member> members_;
};

}  // namespace zeroset
