#include "papers/commands/compare_voxels.hpp"

#include "app/cli/report.hpp"
#include "engine/real/rounding.hpp"
#include "engine/trace/trace_frame.hpp"
#include "papers/commands/compare_output.hpp"
#include "papers/commands/compare_scene.hpp"
#include "papers/commands/compare_subject.hpp"
#include "papers/compare/text_columns.hpp"
#include "papers/compare/voxel_rows.hpp"
#include "papers/voxels/collect_voxels.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Rays that are timed together.
constexpr std::size_t rays_at_once = 256;

struct VoxelPlan {
    CompareFrames frames;
    TraceSettings settings;
    std::vector<PrintedScene> scenes;
};

/// The rows of a table: of single voxels, and of frames of the scenes.
struct VoxelResult {
    std::vector<VoxelRow> rows;
    std::vector<ComparedRow> frames;
};

OrInputError<std::vector<PrintedScene>> scenes_of(const CompareCommand& command) {
    const std::vector<PrintedScene>& all = printed_tables().voxel_scenes;
    if (!command.surfaces || command.surfaces == "all") return all;
    std::string names;
    for (const PrintedScene& scene : all) {
        if (scene.name == *command.surfaces) return std::vector{scene};
        names += " " + scene.name;
    }
    return wrong_input("--surface " + *command.surfaces +
                       ": there is no such scene; type all, or one of:" + names);
}

/// An error for an option that the table has no use for.
std::optional<InputError> refused(const CompareCommand& command, const VoxelTable& table) {
    const std::string has = table.name + ": it has ";
    if (command.tracers)
        return InputError{.reason = has + "all methods of the paper and beams; leave out --tracer"};
    if (!table.synthetic) return std::nullopt;
    for (const auto& [option, value] :
         {std::pair("--surface", &command.surfaces), std::pair("--dstop", &command.d_stop),
          std::pair("--size", &command.size), std::pair("--threads", &command.threads),
          std::pair("--repeat", &command.repeat)}) {
        if (*value)
            return InputError{.reason = has + "single voxels and no frames; leave out " + option};
    }
    return std::nullopt;
}

OrInputError<VoxelPlan> plan_of(const CompareCommand& command, const VoxelTable& table) {
    if (auto wrong = refused(command, table)) return std::unexpected(std::move(*wrong));
    VoxelPlan plan;
    auto scenes = scenes_of(command);
    if (!scenes) return std::unexpected(scenes.error());
    plan.scenes = std::move(*scenes);
    const auto frames = read_frames(command, "640x480");
    if (!frames) return std::unexpected(frames.error());
    plan.frames = *frames;
    TraceText text;
    text.threads = command.threads.value_or("1");
    text.d_stop = command.d_stop.value_or("14");
    auto settings = read_trace_settings(text);
    if (!settings) return std::unexpected(settings.error());
    plan.settings = std::move(*settings);
    return plan;
}

/// Adds a row for each method of the table.
void measure_voxels(const VoxelTable& table, const std::string& scene,
                    const std::vector<VoxelRays>& voxels, const CompareOutput& output,
                    VoxelResult& result) {
    const auto proved = proved_roots(voxels);
    for (const PrintedVoxels& printed : table.rows) {
        VoxelRow& row = result.rows.emplace_back(measured_voxels(table, printed, voxels, proved));
        row.scene = scene;
        output.print(voxel_row_text(table, row));
    }
}

/// The voxels that the rays of the scene's frame go through.
std::vector<VoxelRays> voxels_of(const CompareSubject& subject, const VoxelPlan& plan) {
    const Scene& scene = subject.scene();
    const ViewFrame view(subject.camera());
    const ImageSize image{.width = plan.frames.size.width, .height = plan.frames.size.height};
    const UpwardRounding upward;
    return collect_voxels(
        trace_frame(scene, scene.surfaces.front(), view, image, plan.settings.stop), rays_at_once);
}

void measure_frames(const VoxelTable& table, const CompareSubject& subject, const VoxelPlan& plan,
                    VoxelResult& result) {
    const int d_stop = static_cast<int>(plan.settings.stop.value);
    TraceSettings settings = plan.settings;
    result.frames.push_back(subject.measured(d_stop, settings, plan.frames));
    for (const PrintedVoxels& printed : table.rows) {
        settings.tracer = name_of(printed.method);
        result.frames.push_back(subject.measured(d_stop, settings, plan.frames));
    }
}

OrInputError<VoxelResult> measure(const VoxelTable& table, const VoxelPlan& plan,
                                  const CompareOutput& output) {
    VoxelResult result;
    if (table.synthetic) {
        constexpr std::size_t rays = std::size_t{256} * 256;
        measure_voxels(table, "synthetic", synthetic_voxels(rays, rays_at_once), output, result);
        return result;
    }
    for (const PrintedScene& scene : plan.scenes) {
        const auto subject = CompareSubject::make(item_of(scene), plan.frames);
        if (!subject) return std::unexpected(subject.error());
        measure_voxels(table, scene.name, voxels_of(*subject, plan), output, result);
        measure_frames(table, *subject, plan, result);
    }
    return result;
}

/// Frames by beams and by the methods.
std::string frames_text(const VoxelPlan& plan, const std::vector<ComparedRow>& frames) {
    if (frames.empty()) return {};
    return formatted(
               "\nFrames of %dx%d, %d thread(s), medians of %d; pixels unlike those proved by "
               "beams "
               "at d_stop 22: missed, added, moved.\n\n",
               plan.frames.size.width, plan.frames.size.height, plan.settings.threads,
               plan.frames.repeats) +
           voxel_frames_text(frames);
}

}  // namespace

int run_compare_voxels(const CompareCommand& command, const VoxelTable& table) {
    const auto plan = plan_of(command, table);
    if (!plan) return report(plan.error());
    const CompareOutput output(command.json);
    if (const auto message = output.unwritable()) return report_run_time(*message);
    output.print(voxel_heading_text(table));
    const auto result = measure(table, *plan, output);
    if (!result) return report(result.error());
    output.print(frames_text(*plan, result->frames));
    return output.finish(json_of(table, result->rows, result->frames));
}

}  // namespace zeroset
