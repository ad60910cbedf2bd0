#pragma once

#include "engine/image/frame_pool.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/render/render_request.hpp"
#include "engine/render/resolution.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/tile_grid.hpp"
#include "engine/trace/time_limit.hpp"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace zeroset {

/// A picture while its tiles are drawn. It can be looked at meanwhile: the tiles that are done, and
/// a coarser picture of the same view elsewhere.
class GrowingPicture {
public:
    using Clock = TimeLimit::Clock;

    /// How it is drawn.
    struct Plan {
        TraceSettings settings;
        TimeLimit limit = {};
        Clock::duration first_turn = {};  ///< see RenderWatch
        /// The coarser picture; nullptr: nobody looks before the end.
        std::shared_ptr<const Framebuffer> coarser = nullptr;
        Clock::duration shown_after = {};  ///< the time between two looks
        /// Called for each look with the picture and the time that it took so far, from the threads
        /// that draw, by one of them at a time.
        std::function<void(std::shared_ptr<const Framebuffer>, double)> show = {};
    };

    /// `request`, whose settings do not count, and `pool` must outlive it.
    GrowingPicture(const RenderRequest& request, FramePool& pool, Plan plan);

    /// Draws it to its end, or until its time has run out; false if it was cancelled.
    bool draw();
    /// True if it came to its end before its time ran out.
    [[nodiscard]] bool complete() const { return complete_; }
    /// The share of its pixels that were left out when its time ran out.
    [[nodiscard]] double cut_share() const { return cut_share_; }
    [[nodiscard]] const std::shared_ptr<Framebuffer>& frame() const { return frame_; }
    [[nodiscard]] double elapsed_ms() const;
    /// Tells what the picture costs; from a good part of it, where it did not come to its end.
    void tell(ResolutionGovernor& governor) const;

private:
    void finish_tile(const PixelRect& rect);
    /// The picture as one who looks sees it now.
    [[nodiscard]] std::shared_ptr<const Framebuffer> snapshot() const;

    const RenderRequest& request_;
    FramePool& pool_;
    Plan plan_;
    bool complete_ = false;
    double cut_share_ = 0.0;
    std::shared_ptr<Framebuffer> frame_;
    TileGrid grid_;
    std::vector<std::atomic<bool>> done_;  ///< a tile's pixels are written before
    std::mutex showing_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_ = start_;  ///< guarded by showing_
};

}  // namespace zeroset
