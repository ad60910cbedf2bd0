#pragma once

#include "engine/trace/time_limit.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

namespace zeroset {

/// Deals out the time until a limit to tiles, some of which take far longer than others: each gets
/// a fair share of what is left, and those that would need more get more than they had, for as long
/// as there is time. Without a limit each has all the time, or if there is a first turn that long,
/// then four times as long, and so on.
class TileTurns {
public:
    using Duration = TimeLimit::Clock::duration;

    TileTurns(std::size_t tiles, int threads, const TimeLimit& limit,
              Duration first_turn = Duration::zero())
        : limit_(limit),
          threads_(threads),
          first_turn_(first_turn),
          had_(tiles, Duration::zero()) {}

    /// Begins a round of so many turns.
    void begin(std::size_t turns) { waiting_ = turns; }
    /// The next turn is this tile's; nothing where it would get no more time than it had. Any
    /// thread.
    std::optional<TimeLimit> take(std::size_t tile) {
        const std::size_t waiting = waiting_--;
        if (limit_.until == TimeLimit::never && first_turn_ == Duration::zero()) return limit_;
        const auto now = TimeLimit::Clock::now();
        if (limit_.until == TimeLimit::never) {
            had_[tile] = std::max(first_turn_, 4 * had_[tile]);
            return TimeLimit{.cancel = limit_.cancel, .until = now + had_[tile]};
        }
        const Duration left = std::max<Duration>(limit_.until - now, Duration::zero());
        const Duration fair = left * threads_ / static_cast<long>(waiting);
        Duration& had = had_[tile];
        const bool first = had == Duration::zero();
        if (!first && left <= had) return std::nullopt;
        const Duration share = std::min(left, std::max(fair, 2 * had));
        had = std::max(share, Duration(1));
        return TimeLimit{.cancel = limit_.cancel,
                         .until = share == left ? limit_.until : now + share};
    }

private:
    TimeLimit limit_;
    int threads_;
    Duration first_turn_;
    std::atomic<std::size_t> waiting_ = 0;
    std::vector<Duration> had_;  ///< of each tile: its last share
};

}  // namespace zeroset
