#include "papers/octree/octree_memory.hpp"

#include "papers/octree/voxelisation.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace zeroset {

std::shared_ptr<const Octree> OctreeMemory::find(const Kept& like, int level) {
    const auto found = std::ranges::find_if(kept_, [&](const Kept& kept) {
        return kept.clip == like.clip && kept.precision == like.precision &&
               kept.uniforms == like.uniforms && kept.octree->depth() >= level;
    });
    return found == kept_.end() ? nullptr : found->octree;
}

std::shared_ptr<const Octree> OctreeMemory::octree(const TraceFrame& frame, int level,
                                                   int threads) {
    const auto uniforms = frame.scene.uniforms.all_boxes<double>();
    Kept own{.clip = frame.scene.clip,
             .precision = frame.precision,
             .uniforms = {uniforms.begin(), uniforms.end()},
             .octree = nullptr};
    {
        const std::scoped_lock lock(mutex_);
        if (auto kept = find(own, level)) return kept;
    }
    // Without the lock: a thread that waits for others here may take up another frame meanwhile.
    own.octree = voxelise(frame, level, threads);
    if (own.octree->depth() < level) return own.octree;
    const std::scoped_lock lock(mutex_);
    if (kept_.size() == most_kept) kept_.erase(kept_.begin());
    return kept_.emplace_back(std::move(own)).octree;
}

std::shared_ptr<const PreparedSurface> prepare_octree(const TraceFrame& surface, int threads) {
    if (surface.stopped()) return nullptr;
    // Voxels finer than pixels are met by few rays: 9 levels for 512 pixels, as in the paper.
    const auto pixels = static_cast<unsigned>(std::max(surface.image.width, surface.image.height));
    const int leaves = leaf_level(surface, octree_space(surface.scene.clip)).level;
    const int level =
        std::min({voxel_level, static_cast<int>(std::bit_width(pixels - 1U)), leaves});
    return surface.kernel.memory->of<OctreeMemory>()->octree(surface, level, threads);
}

}  // namespace zeroset
