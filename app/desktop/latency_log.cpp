#include "app/desktop/latency_log.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace zeroset {
namespace {

double ms(LatencyLog::Clock::duration duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
}

const char* name_of(ui::InputEvent::Kind kind) {
    using Kind = ui::InputEvent::Kind;
    switch (kind) {
        case Kind::Move: return "move";
        case Kind::Button: return "button";
        case Kind::Wheel: return "wheel";
        case Kind::Key: return "key";
    }
    return "";
}

}  // namespace

LatencyLog::LatencyLog(const std::string& path) : file_(path) {}

void LatencyLog::input(const ui::InputEvent& event) {
    if (!pending_)
        pending_ = PendingEvent{.event = event, .gl_ms = 0.0, .request = {}, .submitted = {}};
}

void LatencyLog::add_gl(Clock::time_point from, Clock::time_point to) {
    gl_until_ = to;
    if (pending_ && !pending_->request) pending_->gl_ms += ms(to - from);
    if (taken_) taken_->gl_ms += ms(to - from);
}

void LatencyLog::submitted(std::uint64_t request) {
    if (!pending_ || pending_->request) return;
    pending_->request = request;
    pending_->submitted = Clock::now();
}

void LatencyLog::nothing_submitted() {
    if (pending_ && !pending_->request) pending_.reset();
}

void LatencyLog::picture_ready() {
    const std::scoped_lock lock(mutex_);
    if (!ready_) ready_ = Clock::now();
}

void LatencyLog::taken(std::uint64_t request, int width, int height, bool complete) {
    const Clock::time_point now = Clock::now();
    const std::scoped_lock lock(mutex_);
    taken_ = TakenPicture{.request = request,
                          .width = width,
                          .height = height,
                          .complete = complete,
                          .ready = std::exchange(ready_, std::nullopt).value_or(now),
                          .at = now};
}

void LatencyLog::about_to_swap() {
    if (!taken_) return;
    const Clock::time_point now = Clock::now();
    const TakenPicture taken = *std::exchange(taken_, std::nullopt);
    nlohmann::ordered_json line{{"t_s", ms(now - start_) / 1000.0},
                                {"width", taken.width},
                                {"height", taken.height},
                                {"complete", taken.complete}};
    if (pending_ && pending_->request && taken.request >= *pending_->request) {
        const PendingEvent& pending = *pending_;
        const double to_submit = ms(pending.submitted - pending.event.at) - pending.gl_ms;
        const double to_picture = ms(taken.ready - pending.submitted);
        // The picture may have become ready while the thread was in OpenGL.
        const auto free = std::clamp(gl_until_, taken.ready, taken.at);
        const double to_swap = ms(taken.at - free) + ms(now - taken.at) - taken.gl_ms;
        line["event"] = name_of(pending.event.kind);
        line["to_submit_ms"] = to_submit;
        line["to_picture_ms"] = to_picture;
        line["to_swap_ms"] = to_swap;
        line["latency_ms"] = to_submit + to_picture + to_swap;
        line["total_ms"] = ms(now - pending.event.at);
        pending_.reset();
    }
    file_ << line.dump() << '\n' << std::flush;
}

}  // namespace zeroset
