#pragma once

#include "ui/window/window.hpp"

#include <chrono>
#include <cstdint>
#include <fstream>
#include <mutex>
#include <optional>
#include <string>

namespace zeroset {

/// Writes a JSON line for each picture that the window hands to the swap: {"t_s", "width",
/// "height", "complete"}. The first picture after an input event also says how long it took:
///   "event"          "move" (pointer), "button", "wheel" or "key"
///   "to_submit_ms"   from the event's arrival in the program to the request for a picture
///   "to_picture_ms"  from the request to the first traced pixels of a picture
///   "to_swap_ms"     from those pixels to just before the swap of the frame that has them
///   "latency_ms"     the sum of the three
///   "total_ms"       from the event to the swap by the clock
/// Time that the window's thread spent in OpenGL (drawing the panels, upload, swap) counts in
/// total_ms only: without a graphics card it is the time of a software renderer. An event that
/// comes while another waits for its picture is not measured.
/// picture_ready() may be called from any thread, all else from the window's thread only.
class LatencyLog {
public:
    using Clock = std::chrono::steady_clock;

    explicit LatencyLog(const std::string& path);

    void input(const ui::InputEvent& event);
    /// Counts its lifetime as time of the window's thread in OpenGL; `log` may be null.
    class InOpenGl {
    public:
        explicit InOpenGl(LatencyLog* log) : log_(log), from_(Clock::now()) {}
        ~InOpenGl() {
            if (log_ != nullptr) log_->add_gl(from_, Clock::now());
        }
        InOpenGl(const InOpenGl&) = delete;
        InOpenGl& operator=(const InOpenGl&) = delete;

    private:
        LatencyLog* log_;
        Clock::time_point from_;
    };

    void submitted(std::uint64_t request);
    /// Says that the event led to no picture, so that none is waited for.
    void nothing_submitted();
    void picture_ready();
    /// Says that a picture was taken from the job and will be in the next swap.
    void taken(std::uint64_t request, int width, int height, bool complete);
    void about_to_swap();

private:
    struct PendingEvent {
        ui::InputEvent event;
        double gl_ms = 0.0;  ///< time in OpenGL between event and request
        std::optional<std::uint64_t> request;
        Clock::time_point submitted;
    };
    struct TakenPicture {
        std::uint64_t request;
        int width, height;
        bool complete;
        Clock::time_point ready, at;
        double gl_ms = 0.0;  ///< time in OpenGL since `at`
    };
    void add_gl(Clock::time_point from, Clock::time_point to);

    std::ofstream file_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point gl_until_ = start_;
    std::optional<PendingEvent> pending_;
    std::optional<TakenPicture> taken_;
    std::mutex mutex_;
    std::optional<Clock::time_point> ready_;  ///< when the first picture not yet taken became ready
};

}  // namespace zeroset
