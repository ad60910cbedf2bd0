#pragma once

#include "engine/trace/trace_frame.hpp"
#include "papers/octree/octree.hpp"

#include <memory>
#include <mutex>
#include <vector>

namespace zeroset {

/// The latest octrees of a kernel (Kernel::memory): they stay as they are until the formula, w or a
/// parameter, the clip box or the precision changes, whatever the camera does. Any thread.
class OctreeMemory {
public:
    /// The frame's octree down to `level`, or to a deeper one; made on so many threads where there
    /// is none. One that the frame's limit ended is not kept.
    std::shared_ptr<const Octree> octree(const TraceFrame& frame, int level, int threads);

private:
    static constexpr std::size_t most_kept = 4;

    struct Kept {
        Box clip;
        Precision precision;
        std::vector<double> uniforms;  ///< Uniforms::boxes, in double
        std::shared_ptr<const Octree> octree;
    };
    [[nodiscard]] std::shared_ptr<const Octree> find(const Kept& like, int level);

    std::mutex mutex_;
    std::vector<Kept> kept_;  ///< the latest one last
};

/// TracerNeeds::prepare of the tracers in this room.
std::shared_ptr<const PreparedSurface> prepare_octree(const TraceFrame& surface, int threads);

}  // namespace zeroset
