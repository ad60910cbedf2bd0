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
/// "height", "complete"}. The first one that follows an input event also says how long that took:
///   "event"          "move" (pointer), "button", "wheel" or "key"
///   "to_submit_ms"   from the event's arrival in the program until the request for a picture
///   "to_picture_ms"  from there until the first pixels of a picture are traced
///   "to_swap_ms"     from there until the frame that has them is about to be swapped
///   "latency_ms"     the sum of the three
///   "total_ms"       from the event to the swap by the clock
/// Time in which the window's thread was in OpenGL (drawing the panels, the upload, the swap) is in
/// total_ms alone: on a machine without a graphics card it is that of software. An event that came
/// while another waited for its picture is not measured.
/// picture_ready() may be called from any thread, the rest from the window's.
class LatencyLog {
public:
    using Clock = std::chrono::steady_clock;

    explicit LatencyLog(const std::string& path);

    void input(const ui::InputEvent& event);
    /// While it lives, the window's thread is in OpenGL; `log` may be null.
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
    /// Nothing that the window waits for comes of the event.
    void nothing_submitted();
    void picture_ready();
    /// A picture was taken from the job; it will be in the next swap.
    void taken(std::uint64_t request, int width, int height, bool complete);
    void about_to_swap();

private:
    struct Waiting {
        ui::InputEvent event;
        double gl_ms = 0.0;  ///< in OpenGL, between the event and the request
        std::optional<std::uint64_t> request;
        Clock::time_point submitted;
    };
    struct Taken {
        std::uint64_t request;
        int width, height;
        bool complete;
        Clock::time_point ready, at;
        double gl_ms = 0.0;  ///< in OpenGL since
    };
    void add_gl(Clock::time_point from, Clock::time_point to);

    std::ofstream file_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point gl_until_ = start_;
    std::optional<Waiting> waiting_;
    std::optional<Taken> taken_;
    std::mutex mutex_;
    std::optional<Clock::time_point> ready_;  ///< the first picture that was not taken yet
};

}  // namespace zeroset
