#include "papers/commands/compare_animation.hpp"

#include "app/cli/report.hpp"
#include "engine/base/clock.hpp"
#include "engine/export/file.hpp"
#include "engine/render/render.hpp"
#include "papers/commands/compare_scene.hpp"
#include "papers/compare/animations.hpp"
#include "papers/florez/cell_grid.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

/// The time that n frames took together.
struct GroupTime {
    double grid_ms = 0.0, frames_ms = 0.0;
    std::size_t crossed = 0;  ///< cells of the last grid

    [[nodiscard]] double ms() const { return grid_ms + frames_ms; }
};

/// The frames from `first` on, by one grid, by a grid for each, and by beams.
struct AnimationRow {
    int first;
    GroupTime together, apart;
    double beams_ms;

    [[nodiscard]] double saved_percent() const {
        return 100.0 * (1.0 - together.ms() / apart.ms());
    }
};

/// An animation, ready to be drawn.
class AnimatedScene {
public:
    AnimatedScene(const PrintedAnimation& animation, Scene scene, const Camera& camera,
                  TraceSettings settings, int size_px, int frames)
        : animation_(animation),
          scene_(std::move(scene)),
          camera_(camera),
          settings_(std::move(settings)),
          frame_(size_px, size_px),
          frames_(frames) {}

    AnimationRow measured(int first) {
        const int last = std::min(first + animation_.n, frames_) - 1;
        AnimationRow row{.first = first, .together = {}, .apart = {}, .beams_ms = 0.0};
        // The longer way first, so that what the first frame warms up is not to its advantage.
        for (int i = first; i <= last; ++i)
            row.beams_ms += drawn_ms(i, "beams");
        row.together = by_grid(first, last);
        for (int i = first; i <= last; ++i) {
            const GroupTime one = by_grid(i, i);
            row.apart.grid_ms += one.grid_ms;
            row.apart.frames_ms += one.frames_ms;
            row.apart.crossed = one.crossed;
        }
        return row;
    }

private:
    [[nodiscard]] double time_at(int frame) const {
        const double share = frames_ > 1 ? static_cast<double>(frame) / (frames_ - 1) : 0.0;
        return animation_.from + share * (animation_.to - animation_.from);
    }
    double drawn_ms(int frame, const char* tracer) {
        scene_.uniforms.set(0, time_at(frame));
        TraceSettings settings = settings_;
        settings.tracer = tracer;
        const auto start = std::chrono::steady_clock::now();
        render_frame(scene_, camera_, settings, frame_);
        return ms_since(start);
    }
    /// Frames by one grid, which is made anew.
    GroupTime by_grid(int first, int last) {
        GroupTime time;
        Surface& surface = scene_.surfaces.front();
        surface.kernel.memory = std::make_shared<KernelMemory>();
        scene_.uniforms.set(0, time_at(first), time_at(last));
        const ViewFrame view(camera_);
        const auto start = std::chrono::steady_clock::now();
        const auto grid = std::static_pointer_cast<const CellGrid>(prepare_cell_grid(
            trace_frame(scene_, surface, view, {.width = frame_.width, .height = frame_.height},
                        settings_.stop),
            settings_.threads));
        time.grid_ms = ms_since(start);
        time.crossed = grid->crossed_cells();
        for (int i = first; i <= last; ++i)
            time.frames_ms += drawn_ms(i, "regular-grid");
        return time;
    }

    const PrintedAnimation& animation_;
    Scene scene_;
    Camera camera_;
    TraceSettings settings_;
    Framebuffer frame_;
    int frames_;
};

void print_heading(const PrintedAnimation& animation, int size_px, const TraceSettings& settings) {
    std::printf(
        "%s; %s.\nHere %dx%d, %d thread(s), %d frames by one grid and by a grid for each; "
        "printed: %.0f to %.0f %% less.\n\n",
        std::string(animation.source).c_str(), std::string(animation.note).c_str(), size_px,
        size_px, settings.threads, animation.n, animation.printed_least, animation.printed_most);
    std::printf("%6s  %9s %10s %6s  %9s %10s %6s  %7s  %9s\n", "frame", "grid ms", "frames ms",
                "cells", "grids ms", "frames ms", "cells", "less", "beams ms");
}

void print_row(const AnimationRow& row) {
    std::printf("%6d  %9.2f %10.2f %6zu  %9.2f %10.2f %6zu  %5.1f %%  %9.2f\n", row.first,
                row.together.grid_ms, row.together.frames_ms, row.together.crossed,
                row.apart.grid_ms, row.apart.frames_ms, row.apart.crossed, row.saved_percent(),
                row.beams_ms);
    std::fflush(stdout);
}

Json json_of(const GroupTime& time) {
    return {{"grid_ms", time.grid_ms}, {"frames_ms", time.frames_ms}, {"cells", time.crossed}};
}

Json json_of(const PrintedAnimation& animation, const std::vector<AnimationRow>& rows) {
    Json json_rows = Json::array();
    for (const AnimationRow& row : rows)
        json_rows.push_back({{"frame", row.first},
                             {"one_grid", json_of(row.together)},
                             {"grid_each", json_of(row.apart)},
                             {"saved_percent", row.saved_percent()},
                             {"beams_ms", row.beams_ms}});
    return {{"table", animation.name},
            {"source", animation.source},
            {"note", animation.note},
            {"n", animation.n},
            {"printed_percent", {animation.printed_least, animation.printed_most}},
            {"rows", json_rows}};
}

}  // namespace

int run_compare_animation(const CompareCommand& command, const PrintedAnimation& animation) {
    const auto settings = read_compared_settings(
        command, std::string(animation.name) + " is an animation", "16", 300);
    if (!settings) return report(settings.error());
    auto compared = compared_scene(animation.formula, animation.domain, *settings);
    if (!compared) return report(compared.error());
    const bool prints = command.json != "-";
    if (command.json && prints) {
        if (auto writable = check_writable(*command.json); !writable)
            return report_run_time(writable.error().message);
    }
    constexpr int frames = 20;
    AnimatedScene animated(animation, std::move(compared->scene), compared->camera,
                           settings->settings, settings->size_px, frames);
    if (prints) print_heading(animation, settings->size_px, settings->settings);
    std::vector<AnimationRow> rows;
    for (int first = 0; first < frames; first += animation.n) {
        rows.push_back(animated.measured(first));
        if (prints) print_row(rows.back());
    }
    if (!command.json) return exit_ok;
    const auto written = write_text(*command.json, json_of(animation, rows).dump(2) + "\n");
    return written ? exit_ok : report_run_time(written.error().message);
}

}  // namespace zeroset
