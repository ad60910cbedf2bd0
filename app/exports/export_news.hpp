#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/image/rgba_image.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace zeroset {

/// How far an export is. Written by the threads that work, read by the window's. Any thread.
class ExportNews {
public:
    using Clock = std::chrono::steady_clock;

    /// `wake` is called when there is a new picture; `now` tells the time.
    explicit ExportNews(std::function<void()> wake,
                        std::function<Clock::time_point()> now = Clock::now)
        : wake_(std::move(wake)), now_(std::move(now)) {}

    std::atomic<bool> cancel = false;

    /// Begins a stage of so many parts; 0: unknown. `unit`: what a part is called where parts are
    /// worth counting, such as "frame", or empty.
    void enter(std::string stage, std::uint64_t parts = 0, std::string unit = "");
    void add(std::uint64_t parts) { done_ += parts; }
    /// The picture as it goes; it is taken over in a small size, and not too often. `rows`: of the
    /// whole picture, of which `frame` is the part that begins at `row`.
    void show(const Framebuffer& frame, int row, int rows);

    /// 0 to 1; 0 while unknown.
    [[nodiscard]] double share() const;
    /// "frame 12 of 180, 8.1 a second, 0:20 left", or the stage.
    [[nodiscard]] std::string text() const;
    /// The newest picture, once.
    std::optional<RgbaImage> take_picture();

private:
    std::function<void()> wake_;
    std::function<Clock::time_point()> now_;
    std::atomic<std::uint64_t> parts_ = 0, done_ = 0;
    mutable std::mutex mutex_;
    std::string stage_, unit_;
    Clock::time_point begun_ = now_(), shown_;
    RgbaImage picture_;
    bool fresh_ = false;
};

/// The seconds as "0:20" or "1:02:03".
std::string clock_text(double seconds);

}  // namespace zeroset
