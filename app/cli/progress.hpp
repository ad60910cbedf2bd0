#pragma once

#include "app/platform/process.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/image/rgba_image.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

namespace zeroset {

/// The progress of a command. Written by working threads, read by the waiting one.
class Progress {
public:
    enum class Stage : std::uint8_t {
        Compiling,
        Fitting,
        Coloring,
        Drawing,
        Filming,
        Dividing,
        Proving,
        Contouring,
        Thinning,
        Writing,
    };

    void enter(Stage stage, std::uint64_t parts = 0) {
        parts_ = parts;
        done_ = 0;
        stage_ = stage;
    }
    void add(std::uint64_t parts) { done_ += parts; }
    /// The picture as it goes: the rows from `row` on, of `rows`.
    void show(const Framebuffer& frame, int row, int rows);
    /// It, in the size of a terminal; empty before there is one.
    [[nodiscard]] RgbaImage picture() const;
    [[nodiscard]] Stage stage() const { return stage_; }
    [[nodiscard]] std::uint64_t parts() const { return parts_; }
    [[nodiscard]] std::uint64_t parts_done() const { return done_; }
    /// From 0 to 1; negative while unknown.
    [[nodiscard]] double done() const {
        const std::uint64_t parts = parts_;
        return parts == 0 ? -1.0 : static_cast<double>(done_) / static_cast<double>(parts);
    }

private:
    std::atomic<Stage> stage_ = Stage::Compiling;
    std::atomic<std::uint64_t> parts_ = 0, done_ = 0;
    mutable std::mutex mutex_;
    RgbaImage picture_;
};

/// "compiling", "drawing", ...
const char* name_of(Progress::Stage stage);

/// Formats a line such as "drawing  [#########           ]  45 %", without line end. `done` as in
/// Progress; if it is unknown, the line shows the seconds instead.
std::string progress_line(Progress::Stage stage, double done, double seconds);

/// Formats a line such as "frame 12 of 180  [##      ]   7 %  8.1 a second, 0:20 left", without
/// line end. `seconds`: since the first frame was begun.
std::string film_line(std::uint64_t done, std::uint64_t frames, double seconds);

/// Runs `work` on a thread of its own and waits for its end, but not beyond `until`. Returns true
/// if it has ended. If standard error is a terminal, it shows the progress of work that takes
/// longer than a second, with the picture as it goes if the terminal has the colours. Unfinished
/// work goes on: whatever it uses must stay alive, and the process must end by end_process
/// (app/platform/process).
bool finish_until(std::chrono::steady_clock::time_point until, const Progress& progress,
                  std::function<void()> work);

/// Clears what shows the progress, if there is anything. Any thread.
void clear_progress();

}  // namespace zeroset
