#include "app/cli/progress.hpp"

#include "app/cli/terminal_picture.hpp"
#include "engine/base/text.hpp"
#include "engine/image/frame_pictures.hpp"

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

/// Columns of a terminal that a picture takes; two rows of pixels are a line.
constexpr int picture_columns = 48;

/// Lines on the terminal above the one that shows the progress; none: -1.
std::atomic<int>& lines_above() {
    static std::atomic<int> lines = -1;
    return lines;
}

/// Writes the picture and the line over those that were there; nothing: clears them.
void write_progress(const RgbaImage& picture, const std::string& line) {
    std::string text = "\r";
    if (const int above = lines_above(); above > 0) text += "\x1b[" + std::to_string(above) + "A";
    text += "\x1b[J";
    lines_above() = line.empty() ? -1 : terminal_lines(picture);
    // A single write cannot be cut in two by another thread that clears it.
    text += terminal_picture(picture) + line;
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
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
        case Progress::Stage::Coloring: return "finding the range of the colors";
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

void Progress::show(const Framebuffer& frame, int row, int rows) {
    const std::scoped_lock lock(mutex_);
    take_over(frame, row, rows, picture_columns, picture_);
}

RgbaImage Progress::picture() const {
    const std::scoped_lock lock(mutex_);
    return picture_;
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
    const bool in_color = on_terminal && has_true_color();
    const auto start = Clock::now();
    const auto has_ended = [&] { return ending->ended; };
    std::unique_lock lock(ending->mutex);
    auto next = on_terminal ? start + shown_after : until;
    while (!ending->wake.wait_until(lock, std::min(next, until), has_ended)) {
        const auto now = Clock::now();
        if (now >= until) break;
        if (now < next) continue;
        const std::chrono::duration<double> elapsed = now - start;
        write_progress(in_color ? progress.picture() : RgbaImage(),
                       line_of(progress, elapsed.count()));
        next = now + shown_every;
    }
    const bool ended = ending->ended;
    lock.unlock();
    clear_progress();
    ended ? thread.join() : thread.detach();
    return ended;
}

void clear_progress() {
    if (lines_above() >= 0) write_progress({}, "");
}

}  // namespace zeroset
