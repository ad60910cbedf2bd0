#pragma once

#include "engine/image/frame_pool.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/render/color_range.hpp"
#include "engine/render/render_request.hpp"
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
    /// Pictures of formulas that nobody has seen yet begin with a trial of a sixteenth of the
    /// pixels, or fewer; it is shown where the first picture is expected to take longer.
    double trial_shown_from_ms = 16.0;
    /// A tile of a full picture that takes longer waits for the others (RenderWatch::first_turn).
    std::chrono::milliseconds first_turn{500};
    /// The time between two looks at a growing picture.
    std::chrono::milliseconds growth_shown_after{60};
};

/// Renders the newest request in the background. A first picture comes as quickly as it takes to
/// draw one at a resolution that holds 60 a second; then, unless requests follow one another, the
/// full one, which replaces it tile by tile, with shadows, smooth edges, mirrors and soft light
/// where they are wanted. Shadows are there while something moves, too, once they are known to be
/// quick enough. All members may be called from the UI thread; none waits for a frame.
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

    /// Phases of the request that the job's thread draws:
    ///
    ///   Idle      -> Blank     begin(): a request came
    ///   Blank     -> Refining  publish(): its first picture is there
    ///   Blank     -> Idle      publish(): its first picture is the complete one
    ///   Refining  -> Refining  publish(): a finer picture is there
    ///   Refining  -> Idle      publish(): the complete picture is there
    ///   any       -> Idle      wait_for_work(): it was overtaken, or first pictures are enough
    enum class Phase : std::uint8_t {
        Idle,      ///< nothing is being drawn
        Blank,     ///< no picture of the request has come yet
        Refining,  ///< a picture has come, finer ones follow
    };
    /// The requests as they come, guarded by the mutex.
    struct Submissions {
        std::optional<RenderRequest> pending;  ///< the newest, until it is drawn
        std::uint64_t newest = 0;              ///< number of the newest; 0: none came yet
        bool in_motion = false;                ///< the newest followed another one closely
        Clock::time_point at;                  ///< when the newest came that was no `again`
    };
    /// The pictures as they go, guarded by the mutex.
    struct Drawing {
        Phase phase = Phase::Idle;
        std::vector<Surface> surfaces;         ///< of the request drawn last
        Clock::time_point published;           ///< when the last picture came
        std::optional<RenderResult> finished;  ///< the newest picture, until it is taken
    };
    /// A request being drawn.
    struct Work {
        RenderRequest request;
        std::uint64_t number = 0;
        bool in_motion = false;  ///< it followed another one closely
        Precision precision = Precision::Float;
        bool finds_range = false;  ///< of the colours
        bool is_new = false;       ///< no picture of its surfaces was shown yet
    };

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
    /// A picture of the moment, by so many pixels along a side, with whatever code there is. It is
    /// shown only if the governor, which it tells its cost, then answers `shown_if` with true.
    First draw_first(const Work& work, double scale, std::chrono::milliseconds within,
                     const std::function<bool()>& shown_if);
    /// A much smaller picture, shown where one of this scale will take long; false when it was
    /// cancelled.
    bool draw_trial(const Work& work, double scale);
    /// The surfaces, then their shadows, then smooth edges, mirrors, soft light, each over the
    /// picture before.
    void draw_full(const Work& work, std::shared_ptr<const Framebuffer> picture);
    /// The settings of full pictures, which are drawn one after the other; without the one of
    /// surfaces alone where their shadows come `at_once`.
    static std::vector<TraceSettings> stages_of(const RenderRequest& request, bool at_once);
    /// Whether a full picture with shadows is known to fit in the time of a first one.
    [[nodiscard]] bool shadows_fit(const RenderRequest& request);
    /// The governor that is told how long pictures of these settings take; or nullptr.
    ResolutionGovernor* governor_of(const TraceSettings& stage);
    /// Whether no other request has come, nor comes for a while if this one was part of a motion.
    bool rests(const Work& work);
    /// Makes the request the one that is drawn; with the mutex held.
    Work begin(RenderRequest request);
    void publish(const Work& work, RenderResult result);
    /// Whether the picture in flight is to be finished although another is wanted: else, while
    /// something moves, there might be none at all.
    [[nodiscard]] bool starving(const RenderRequest& next, Clock::time_point now) const;

    std::function<void()> on_frame_;
    RenderPace pace_;
    FramePool pool_;
    // Used by the job's thread only.
    ResolutionGovernor governor_;  ///< of surfaces alone
    ResolutionGovernor shadowed_;  ///< of surfaces and their shadows
    SteadyRange range_;

    mutable std::mutex mutex_;
    std::condition_variable wake_;
    Submissions submissions_;
    Drawing drawing_;
    bool stop_ = false;                ///< guarded by the mutex
    std::atomic<bool> cancel_{false};  ///< what is being drawn is not wanted any more
    std::thread thread_;
};

}  // namespace zeroset
