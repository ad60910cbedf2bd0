#pragma once

#include "engine/image/framebuffer.hpp"

#include <memory>
#include <mutex>
#include <vector>

namespace zeroset {

/// A pool of framebuffers, to which each returns when its last user lets go of it: making one costs
/// milliseconds. Thread-safe; its frames may outlive it.
class FramePool {
public:
    FramePool() : free_(std::make_shared<Free>()) {}

    /// A frame of this size, with whatever pixels it had before.
    std::shared_ptr<Framebuffer> take(int width, int height);

private:
    struct Free {
        std::mutex mutex;
        std::vector<std::unique_ptr<Framebuffer>> frames;
    };
    std::shared_ptr<Free> free_;
};

}  // namespace zeroset
