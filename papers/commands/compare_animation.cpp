#include "papers/commands/compare_animation.hpp"

#include "app/cli/report.hpp"
#include "engine/base/clock.hpp"
#include "engine/render/render.hpp"
#include "papers/commands/compare_output.hpp"
#include "papers/commands/compare_scene.hpp"
#include "papers/compare/text_columns.hpp"
#include "papers/florez/cell_grid.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
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
    AnimatedScene(const PrintedAnimation& animation, const PictureRequest& request,
                  const ComparedSettings& settings, int frames)
        : animation_(animation),
          scene_(scene_of(request)),
          camera_(request.camera),
          settings_(settings.settings),
          frame_(settings.size_px, settings.size_px),
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

const std::array<TextColumn, 9>& animation_columns() {
    static const std::array<TextColumn, 9> all{{{"frame", "/frame", 6},
                                                {"grid ms", "/one_grid/grid_ms", 10, 2},
                                                {"frames ms", "/one_grid/frames_ms", 10, 2},
                                                {"cells", "/one_grid/cells", 6},
                                                {"grids ms", "/grid_each/grid_ms", 10, 2},
                                                {"frames ms", "/grid_each/frames_ms", 10, 2},
                                                {"cells", "/grid_each/cells", 6},
                                                {"less %", "/saved_percent", 8, 1},
                                                {"beams ms", "/beams_ms", 10, 2}}};
    return all;
}

std::string heading_text(const PrintedAnimation& animation, const ComparedSettings& settings) {
    return animation.source + "; " + animation.note +
           formatted(
               ".\nHere %dx%d, %d thread(s), %d frames by one grid and by a grid for each; "
               "printed: %.0f to %.0f %% less.\n\n",
               settings.size_px, settings.size_px, settings.settings.threads, animation.n,
               animation.printed_percent[0], animation.printed_percent[1]) +
           title_line(animation_columns());
}

Json json_of(const GroupTime& time) {
    return {{"grid_ms", time.grid_ms}, {"frames_ms", time.frames_ms}, {"cells", time.crossed}};
}

Json json_of(const AnimationRow& row) {
    return {{"frame", row.first},
            {"one_grid", json_of(row.together)},
            {"grid_each", json_of(row.apart)},
            {"saved_percent", row.saved_percent()},
            {"beams_ms", row.beams_ms}};
}

}  // namespace

int run_compare_animation(const CompareCommand& command, const PrintedAnimation& animation) {
    const auto settings =
        read_compared_settings(command, animation.name + " is an animation", "16", 300);
    if (!settings) return report(settings.error());
    const auto request = compiled(
        item_of({.name = animation.name, .formula = animation.formula, .domain = animation.domain}),
        settings->settings, settings->size());
    if (!request) return report(request.error());
    const CompareOutput output(command.json);
    if (const auto message = output.unwritable()) return report_run_time(*message);
    constexpr int frames = 20;
    AnimatedScene animated(animation, *request, *settings, frames);
    output.print(heading_text(animation, *settings));
    Json rows = Json::array();
    for (int first = 0; first < frames; first += animation.n) {
        rows.push_back(json_of(animated.measured(first)));
        output.print(row_line(animation_columns(), rows.back()));
    }
    return output.finish({{"table", animation.name},
                          {"source", animation.source},
                          {"note", animation.note},
                          {"n", animation.n},
                          {"printed_percent", animation.printed_percent},
                          {"rows", rows}});
}

}  // namespace zeroset
