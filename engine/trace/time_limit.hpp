#pragma once

#include <atomic>
#include <chrono>
#include <ctime>

namespace zeroset {

/// When work on a picture ends before it is finished.
struct TimeLimit {
    using Clock = std::chrono::steady_clock;
    static constexpr Clock::time_point never = Clock::time_point::max();

    /// True: nothing of the work is wanted any more.
    const std::atomic<bool>* cancel = nullptr;
    /// The time from which on no more is to be found; what has been found is drawn.
    Clock::time_point until = never;

    [[nodiscard]] bool cancelled() const {
        return cancel != nullptr && cancel->load(std::memory_order_relaxed);
    }
    /// Either of the two; takes some nanoseconds. `until` is kept to a few milliseconds.
    [[nodiscard]] bool over() const {
        return cancelled() || (until != never && coarse_now() >= until);
    }
    /// The limit of the first `parts` of `of` equal parts of the time that is left.
    [[nodiscard]] TimeLimit share(int parts, int of) const {
        if (until == never) return *this;
        const auto now = Clock::now();
        return {.cancel = cancel, .until = now + (until - now) / of * parts};
    }

private:
    /// Clock::now() as of the last tick of the kernel: a sixth of its cost.
    static Clock::time_point coarse_now() {
        timespec now{};
        ::clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
        return Clock::time_point(std::chrono::seconds(now.tv_sec) +
                                 std::chrono::nanoseconds(now.tv_nsec));
    }
};

}  // namespace zeroset
