#pragma once

#include "app/platform/process.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace zeroset {

/// How far a command has come. Written by the threads that work, read by the one that waits.
class Progress {
public:
    enum class Stage : std::uint8_t { Compiling, Fitting, Coloring, Drawing };

    void enter(Stage stage, std::uint64_t parts = 0) {
        parts_ = parts;
        done_ = 0;
        stage_ = stage;
    }
    void add(std::uint64_t parts) { done_ += parts; }
    [[nodiscard]] Stage stage() const { return stage_; }
    /// From 0 to 1; negative where it is not known.
    [[nodiscard]] double done() const {
        const std::uint64_t parts = parts_;
        return parts == 0 ? -1.0 : static_cast<double>(done_) / static_cast<double>(parts);
    }

private:
    std::atomic<Stage> stage_ = Stage::Compiling;
    std::atomic<std::uint64_t> parts_ = 0, done_ = 0;
};

/// "compiling", "drawing", ...
const char* name_of(Progress::Stage stage);

/// A line such as "drawing  [#########           ]  45 %", without its end. `done` as in Progress;
/// where it is not known the line tells the seconds.
std::string progress_line(Progress::Stage stage, double done, double seconds);

/// Does `work` on a thread of its own and waits for its end, not beyond `until`; returns whether it
/// has ended. On a terminal standard error shows the progress of what takes longer than a second.
/// Work that has not ended goes on beside: what it uses must live on, and the process is to end by
/// end_process (app/platform/process).
bool finish_until(std::chrono::steady_clock::time_point until, const Progress& progress,
                  std::function<void()> work);

/// Takes the line away that shows the progress, if there is one. Any thread.
void clear_progress();

}  // namespace zeroset
