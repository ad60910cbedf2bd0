#pragma once

#include "engine/image/framebuffer.hpp"

#include <memory>
#include <mutex>
#include <vector>

namespace zeroset {

/// Framebuffers that come back when nobody looks at them any more: making one costs milliseconds.
/// Thread-safe; its frames may outlive it.
class FramePool {
public:
    FramePool() : free_(std::make_shared<Free>()) {}

    /// A frame of this size; its pixels are whatever they were.
    std::shared_ptr<Framebuffer> take(int width, int height);

private:
    struct Free {
        std::mutex mutex;
        std::vector<std::unique_ptr<Framebuffer>> frames;
    };
    std::shared_ptr<Free> free_;
};

}  // namespace zeroset
