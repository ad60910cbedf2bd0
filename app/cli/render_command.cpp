#include "app/cli/commands.hpp"
#include "app/cli/point_json.hpp"
#include "app/cli/render_picture.hpp"
#include "app/cli/report.hpp"
#include "app/platform/process.hpp"
#include "engine/base/parallel.hpp"
#include "engine/export/file.hpp"
#include "engine/render/tracers.hpp"
#include "engine/scene/tolerance.hpp"
#include "pipeline/finish_picture.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/probe_document.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <utility>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

OrInputError<std::vector<glm::ivec2>> read_probes(const std::vector<std::string>& texts,
                                                  const Size& size) {
    std::vector<glm::ivec2> pixels;
    for (const std::string& text : texts) {
        const auto numbers = read_numbers("--probe", text, 2);
        if (!numbers) return std::unexpected(numbers.error());
        const double col = (*numbers)[0];
        const double row = (*numbers)[1];
        const bool inside = col >= 0 && col < size.width && row >= 0 && row < size.height;
        if (!inside || col != std::floor(col) || row != std::floor(row)) {
            return wrong_input("--probe " + text + ": type a pixel COL,ROW, from 0,0 to " +
                               std::to_string(size.width - 1) + "," +
                               std::to_string(size.height - 1));
        }
        pixels.emplace_back(static_cast<int>(col), static_cast<int>(row));
    }
    return pixels;
}

OrInputError<RenderPlan> plan_of(const RenderCommand& command) {
    RenderPlan plan;
    auto size = read_size("--size", command.size);
    if (!size) return std::unexpected(size.error());
    plan.size = *size;
    auto settings = read_trace_settings(command.trace);
    if (!settings) return std::unexpected(settings.error());
    plan.settings = *settings;
    if (command.repeat) {
        auto repeats = read_integer("--repeat", *command.repeat, 1, 100'000);
        if (!repeats) return std::unexpected(repeats.error());
        plan.repeats = *repeats;
        plan.warms_up = true;
    }
    const auto budget = read_budget(command.budget);
    if (!budget) return std::unexpected(budget.error());
    plan.budget_s = *budget;
    plan.fits = command.view.fit;
    plan.fits_box = !command.view.box;
    if (!command.output && !command.depth && !command.certificate && !command.stats &&
        command.probes.empty()) {
        return wrong_input(
            "nothing to write: give -o OUT.png, --depth FILE.pfm, --certificate FILE.png, "
            "--probe COL,ROW or --stats -");
    }
    auto probes = read_probes(command.probes, plan.size);
    if (!probes) return std::unexpected(probes.error());
    plan.probes = std::move(*probes);
    for (const auto& [option, path] :
         {std::pair{"-o ", &command.output}, std::pair{"--certificate ", &command.certificate}}) {
        if (*path && !(*path)->ends_with(".png")) {
            return wrong_input(option + **path +
                               ": the picture is a PNG; type a name that ends in .png");
        }
    }
    if (command.depth == "-") {
        return wrong_input("--depth -: the depths need a file; type a name, for example depth.pfm");
    }
    auto input = read_document(command.equation, command.view);
    if (!input) return std::unexpected(input.error());
    if (!input->rows) return std::unexpected(input->rows.error());
    plan.document = std::move(input->document);
    plan.rows = std::move(*input->rows);
    if (const auto wrong = take_look(command.trace, plan.document)) return std::unexpected(*wrong);
    if (plan.document.jumps && plan.settings.tracer != tracers().front().name) {
        return wrong_input("--jumps: only the tracer beams finds jumps; leave out --tracer " +
                           plan.settings.tracer);
    }
    return plan;
}

/// Returns the error of the first output file that cannot be written.
std::optional<std::string> unwritable_file(const RenderCommand& command) {
    for (const auto* path :
         {&command.output, &command.depth, &command.certificate, &command.stats}) {
        if (!*path || **path == "-") continue;
        if (auto writable = check_writable(**path); !writable) return writable.error().message;
    }
    return std::nullopt;
}

Json stats_of(const RenderedPicture& picture) {
    const RenderPlan& plan = picture.plan;
    const Scene& scene = picture.scene;
    const PictureRequest& request = picture.request;
    const FrameTiming& timing = picture.timing;
    const Framebuffer& frame = picture.frame;
    const Precision precision =
        frame_precision(scene, ViewFrame(request.camera), plan.settings.stop);
    Json surfaces = Json::array();
    for (const std::size_t pixels : count_surfaces(frame, scene.surfaces.size()))
        surfaces.push_back({{"pixels", pixels}});
    const CertificateCounts counts = count_certificates(frame);
    const auto width = certified_width(scene.clip, plan.settings.stop, precision);
    const int threads = plan.settings.threads > 0 ? plan.settings.threads : core_count();
    return {{"width", frame.width},
            {"height", frame.height},
            {"threads", threads},
            {"tracer", plan.settings.tracer},
            {"compile_ms", request.formula ? request.formula->compile_ms : 0.0},
            {"machine_code", !request.formula || request.formula->code == CodeState::Machine},
            {"precision", name_of(precision)},
            {"frame_ms",
             {{"median", timing.median_ms},
              {"min", timing.min_ms},
              {"max", timing.max_ms},
              {"repeats", timing.repeats}}},
            {"certified", counts.certified},
            {"undecided", counts.undecided},
            {"miss", counts.miss},
            {"jumps", counts.jumps},
            {"undecided_not_drawn", counts.not_drawn},
            {"undecided_by_budget", timing.counters.cut_pixels},
            {"certified_coarse", counts.coarse},
            {"coarse_width", counts.coarse > 0 ? Json(timing.counters.coarse_width) : Json()},
            {"certified_width", width ? Json(*width) : Json()},
            {"surfaces", surfaces},
            {"evaluations",
             {{"range", timing.counters.range},
              {"value", timing.counters.value},
              {"form", timing.counters.form}}}};
}

/// Returns the reading of each of the program's surfaces.
std::vector<std::string> surface_readings(const Program& program) {
    std::vector<std::string> texts;
    for (const Reading& reading : program.readings) {
        if (reading.kind == StatementKind::Surface) texts.push_back(reading.text);
    }
    return texts;
}

void print_probes(const RenderedPicture& picture) {
    const RenderPlan& plan = picture.plan;
    const Scene& scene = picture.scene;
    const PictureRequest& request = picture.request;
    const std::vector<std::size_t> shown = shown_indices(request);
    const std::vector<Kernel> typed = typed_formulas(*plan.rows.program, shown);
    const std::vector<std::string> readings = surface_readings(*plan.rows.program);
    const StopCriterion& stop = plan.settings.stop;
    const Precision precision = frame_precision(scene, ViewFrame(request.camera), stop);
    const double tolerance = depth_tolerance(scene.clip, stop, precision);
    for (const glm::ivec2& pixel : plan.probes) {
        const auto facts = probe({.frame = picture.frame,
                                  .camera = request.camera,
                                  .formulas = typed,
                                  .uniforms = scene.uniforms,
                                  .tolerance = tolerance},
                                 pixel.x, pixel.y);
        const std::size_t surface = facts ? shown[facts->surface] : 0;
        std::cout << json_line(pixel.x, pixel.y, facts, surface + 1, readings[surface]);
    }
}

/// Writes the requested files; returns an error if one cannot be written.
std::expected<void, std::string> write_files(const RenderCommand& command,
                                             const std::shared_ptr<const RenderedPicture>& made) {
    const RenderedPicture& picture = *made;
    const Framebuffer& frame = picture.frame;
    std::expected<void, FileError> written;
    if (command.output) {
        const FrameSubject subject{.document = picture.plan.document,
                                   .camera = picture.request.camera,
                                   .coloring = picture.scene.coloring,
                                   .legend = !command.no_legend};
        const auto finished = finish_picture({made, &frame}, subject);
        if (!finished) return std::unexpected(finished.error());
        written = command.alpha ? write_png(*command.output, without_background(frame, **finished))
                                : write_png(*command.output, **finished);
    }
    if (written && command.depth) written = write_pfm(*command.depth, frame);
    if (written && command.certificate)
        written = write_png(*command.certificate, certificate_picture(frame));
    if (written && command.stats)
        written = write_text(*command.stats, stats_of(picture).dump(2) + "\n");
    if (!written) return std::unexpected(written.error().message);
    return {};
}

int finish(const RenderCommand& command, const std::shared_ptr<const RenderedPicture>& made) {
    const RenderedPicture& picture = *made;
    if (picture.error) return report(*picture.error);
    if (!picture.note.empty()) std::cerr << "zeroset: --fit: " << picture.note << '\n';
    const std::string left = budget_note(picture);
    if (!left.empty()) std::cerr << "zeroset: " << left << '\n';
    print_probes(picture);
    const auto written = write_files(command, made);
    return written ? exit_ok : report_run_time(written.error());
}

}  // namespace

int run_render(const RenderCommand& command) {
    const auto start = std::chrono::steady_clock::now();
    const auto plan = plan_of(command);
    if (!plan) return report(plan.error());
    if (const auto message = unwritable_file(command)) return report_run_time(*message);
    const RenderOutcome outcome = render_picture(*plan, start);
    const int exit_code = finish(command, outcome.picture);
    if (outcome.stuck) end_process(exit_code);
    return exit_code;
}

}  // namespace zeroset
