#include "engine/image/frame_pool.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace zeroset {
namespace {

constexpr std::size_t most_frames = 4;

}  // namespace

std::shared_ptr<Framebuffer> FramePool::take(int width, int height) {
    std::unique_ptr<Framebuffer> frame;
    {
        const std::scoped_lock lock(free_->mutex);
        auto& frames = free_->frames;
        frames.reserve(most_frames);
        const auto fits = std::ranges::find_if(frames, [&](const auto& candidate) {
            return candidate->width == width && candidate->height == height;
        });
        if (fits != frames.end()) {
            frame = std::move(*fits);
            frames.erase(fits);
        }
    }
    if (!frame) frame = std::make_unique<Framebuffer>(width, height);
    const auto give_back = [free = free_](Framebuffer* used) {
        std::unique_ptr<Framebuffer> owned(used);
        const std::scoped_lock lock(free->mutex);
        // Drop the oldest frame, as sizes change.
        if (free->frames.size() == most_frames) free->frames.erase(free->frames.begin());
        free->frames.push_back(std::move(owned));
    };
    return {frame.release(), give_back};
}

}  // namespace zeroset
