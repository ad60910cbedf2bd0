#pragma once

#include "engine/image/frame_pool.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/render/color_range.hpp"
#include "engine/render/resolution.hpp"
#include "engine/scene/precision.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace zeroset {

/// Everything one picture depends on; a snapshot.
struct RenderRequest {
    Scene scene;
    Camera camera;
    TraceSettings settings;
    int width = 0;  ///< of the full picture, pixels
    int height = 0;
    /// Quicker code is on its way, with which the picture will be asked for again: where the full
    /// one takes long, only first pictures are drawn.
    bool preview = false;
    /// The picture of the request before, by other code: it follows no motion.
    bool again = false;
};

/// A picture as far as it has come. It is smaller than the full one, to be shown stretched, or as
/// large.
struct RenderResult {
    std::shared_ptr<const Framebuffer> frame;
    std::uint64_t request = 0;  ///< what submit() returned
    bool complete = false;      ///< the full picture, to its last pixel
    double frame_ms = 0.0;      ///< that tracing it has taken so far
    CertificateCounts counts;   ///< of a complete one
    Camera camera;
    Precision precision = Precision::Float;
    Coloring coloring = {};  ///< with the range that was found, if there is one
};

/// When a RenderJob does what.
struct RenderPace {
    /// The time for a first picture: with what the window does besides it makes 60 a second.
    double budget_ms = 12.0;
    /// A full picture that is this quick needs none before it, unless something moves.
    double at_once_ms = 25.0;
    /// Requests that follow one another so closely are one motion; it has ended when none comes for
    /// that long.
    std::chrono::milliseconds rest_after{120};
    /// Nothing new for so long on the screen: the picture in flight is finished first.
    std::chrono::milliseconds starving_after{66};
    /// A first picture ends when it takes longer, with what is not decided left out; it is drawn
    /// again with four times as long, some times.
    std::chrono::milliseconds first_within{150};
    /// A tile of a full picture that takes longer waits for the others (RenderWatch::first_turn).
    std::chrono::milliseconds first_turn{500};
    /// The time between two looks at a growing picture.
    std::chrono::milliseconds growth_shown_after{60};
};

/// Renders the newest request in the background. A first picture comes as quickly as it takes to
/// draw one at a resolution that holds 60 a second; then, unless requests follow one another, the
/// full one, which replaces it tile by tile, with shadows and antialiased where that is wanted. All
/// members may be called from the UI thread; none waits for a frame.
class RenderJob {
public:
    /// `on_frame` is called from the job's threads after each picture.
    explicit RenderJob(std::function<void()> on_frame, const RenderPace& pace = {});
    ~RenderJob();
    RenderJob(const RenderJob&) = delete;
    RenderJob& operator=(const RenderJob&) = delete;

    /// Starts on `request`; what was being drawn ends within milliseconds, unless that would leave
    /// the screen without any new picture for long. Returns its number.
    std::uint64_t submit(RenderRequest request);
    /// The newest picture not yet taken, or nothing.
    std::optional<RenderResult> take();
    /// Whether a request is waiting or being drawn.
    [[nodiscard]] bool busy() const;

private:
    using Clock = std::chrono::steady_clock;

    /// A request being drawn.
    struct Work {
        RenderRequest request;
        std::uint64_t number = 0;
        bool in_motion = false;  ///< it followed another one closely
        Precision precision = Precision::Float;
        bool finds_range = false;  ///< of the colours
        bool is_new = false;       ///< no picture of its surfaces was shown yet
    };
    class GrowingPicture;

    void run();
    /// The next request; nothing at the end.
    std::optional<Work> wait_for_work();
    void draw(Work work);
    /// The first pictures of a request, the last of them; nothing when it was overtaken.
    std::shared_ptr<const Framebuffer> draw_firsts(Work& work);
    /// Finds the range of the colours where the request leaves it open: the last one, unless it is
    /// to be found `anew`.
    void find_colors(Work& work, bool anew);
    struct First {
        std::shared_ptr<const Framebuffer> frame;  ///< nothing when it was cancelled
        bool complete;
    };
    /// A picture of the moment, by so many pixels along a side, with whatever code there is.
    First draw_first(const Work& work, double scale, std::chrono::milliseconds within);
    /// The surfaces, then their shadows, then smooth edges, each over the picture before.
    void draw_full(const Work& work, std::shared_ptr<const Framebuffer> picture);
    static std::vector<TraceSettings> stages_of(const TraceSettings& settings);
    /// Whether no other request has come, nor comes for a while if this one was part of a motion.
    bool rests(const Work& work);
    void publish(const Work& work, RenderResult result);
    /// Whether the picture in flight is to be finished although another is wanted: else, while
    /// something moves, there might be none at all.
    [[nodiscard]] bool starving(const RenderRequest& next, Clock::time_point now) const;

    std::function<void()> on_frame_;
    RenderPace pace_;
    FramePool pool_;
    ResolutionGovernor governor_;  ///< the job's thread's
    SteadyRange range_;            ///< likewise

    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<RenderRequest> pending_;
    std::optional<RenderResult> finished_;
    std::uint64_t newest_ = 0;
    Clock::time_point submitted_;  ///< the newest request
    Clock::time_point published_;  ///< the last picture
    bool pending_in_motion_ = false;
    bool drawing_ = false;
    bool first_ = false;            ///< no picture of the request being drawn has come yet
    std::vector<Kernel> surfaces_;  ///< of the request being drawn
    bool stop_ = false;
    std::atomic<bool> cancel_{false};
    std::thread thread_;
};

}  // namespace zeroset
