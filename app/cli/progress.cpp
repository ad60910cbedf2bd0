#include "app/cli/progress.hpp"

#include "engine/base/text.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace zeroset {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto shown_after = std::chrono::seconds(1);
constexpr auto shown_every = std::chrono::milliseconds(100);

std::atomic<bool>& is_shown() {
    static std::atomic<bool> shown = false;
    return shown;
}

void write_line(const std::string& text) {
    // A single write cannot be cut in two by another thread that clears the line.
    const std::string line = "\r\x1b[K" + text;
    is_shown() = !text.empty();
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
}

/// State shared by the working thread and the one that waits for it.
struct Ending {
    std::mutex mutex;
    std::condition_variable wake;
    bool ended = false;
};

/// "  [#########           ]   45 %".
std::string bar(double part) {
    constexpr std::size_t width = 30;
    const auto full = static_cast<std::size_t>(part * width);
    const std::string percent = std::to_string(static_cast<int>(100.0 * part));
    return "  [" + std::string(full, '#') + std::string(width - full, ' ') + "]  " +
           std::string(3 - percent.size(), ' ') + percent + " %";
}

/// The line for what is going on, `seconds` after the beginning.
std::string line_of(const Progress& progress, double seconds) {
    if (progress.stage() != Progress::Stage::Filming)
        return progress_line(progress.stage(), progress.done(), seconds);
    return film_line(progress.parts_done(), progress.parts(), seconds);
}

}  // namespace

const char* name_of(Progress::Stage stage) {
    switch (stage) {
        case Progress::Stage::Compiling: return "compiling";
        case Progress::Stage::Fitting: return "looking for the surface";
        case Progress::Stage::Coloring: return "finding the range of the colours";
        case Progress::Stage::Drawing: return "drawing";
        case Progress::Stage::Filming: return "filming";
        case Progress::Stage::Dividing: return "dividing cells";
        case Progress::Stage::Proving: return "proving the topology";
        case Progress::Stage::Contouring: return "making triangles";
        case Progress::Stage::Thinning: return "thinning";
        case Progress::Stage::Writing: return "writing";
    }
    return "";
}

std::string progress_line(Progress::Stage stage, double done, double seconds) {
    const std::string name = name_of(stage);
    if (!(done >= 0.0)) return name + ", " + std::to_string(std::lround(seconds)) + " s";
    return name + bar(std::min(done, 1.0));
}

std::string film_line(std::uint64_t done, std::uint64_t frames, double seconds) {
    const double part = static_cast<double>(done) / static_cast<double>(frames);
    std::string line =
        "frame " + std::to_string(done) + " of " + std::to_string(frames) + bar(part);
    if (done == 0 || !(seconds > 0)) return line;
    const double rate = static_cast<double>(done) / seconds;
    const auto left = std::lround(static_cast<double>(frames - done) / rate);
    const std::string part_of_minute = std::to_string(left % 60);
    return line + "  " + short_number(rate, 3) + " a second, " + std::to_string(left / 60) + ":" +
           (part_of_minute.size() < 2 ? "0" : "") + part_of_minute + " left";
}

bool finish_until(Clock::time_point until, const Progress& progress, std::function<void()> work) {
    const auto ending = std::make_shared<Ending>();
    std::thread thread([ending, work = std::move(work)] {
        work();
        const std::scoped_lock lock(ending->mutex);
        ending->ended = true;
        ending->wake.notify_one();
    });
    const bool on_terminal = ::isatty(STDERR_FILENO) == 1;
    const auto start = Clock::now();
    const auto has_ended = [&] { return ending->ended; };
    std::unique_lock lock(ending->mutex);
    auto next = on_terminal ? start + shown_after : until;
    while (!ending->wake.wait_until(lock, std::min(next, until), has_ended)) {
        const auto now = Clock::now();
        if (now >= until) break;
        if (now < next) continue;
        const std::chrono::duration<double> elapsed = now - start;
        write_line(line_of(progress, elapsed.count()));
        next = now + shown_every;
    }
    const bool ended = ending->ended;
    lock.unlock();
    clear_progress();
    ended ? thread.join() : thread.detach();
    return ended;
}

void clear_progress() {
    if (is_shown()) write_line("");
}

}  // namespace zeroset
