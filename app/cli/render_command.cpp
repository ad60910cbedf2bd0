#include "app/cli/commands.hpp"
#include "app/cli/mesh_report.hpp"
#include "app/cli/options/option_reader.hpp"
#include "app/cli/options/view_options.hpp"
#include "app/cli/render_files.hpp"
#include "app/cli/render_picture.hpp"
#include "app/cli/report.hpp"
#include "app/platform/process.hpp"
#include "engine/base/parallel.hpp"
#include "engine/export/file.hpp"
#include "engine/scene/tolerance.hpp"
#include "engine/trace/trace_frame.hpp"
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

// The most pixels of pictures that are in memory as a whole; fewer where they keep their light.
constexpr long long whole_pixels = 16 << 20;
constexpr long long whole_light_pixels = 4 << 20;

bool is_drawn_in_bands(const RenderPlan& plan) {
    const long long pixels = static_cast<long long>(plan.size.width) * plan.size.height;
    return pixels > (needs_light(plan.picture) ? whole_light_pixels : whole_pixels);
}

/// The error for an option that cannot go with a picture that is never in memory as a whole.
std::optional<InputError> refused_in_bands(const RenderCommand& command, const RenderPlan& plan) {
    if (!plan.in_bands) return std::nullopt;
    const auto refused = [&](const std::string& option) {
        return InputError{.reason = option + ": not with a picture of " + command.size +
                                    " pixels, which is never in memory as a whole; type a "
                                    "smaller --size"};
    };
    if (command.repeat) return refused("--repeat " + *command.repeat);
    if (!command.probes.empty()) return refused("--probe " + command.probes.front());
    return std::nullopt;
}

/// An error where nothing is to be written, or a picture to a file that would be none.
std::optional<InputError> check_outputs(const RenderCommand& command) {
    if (!command.output && !command.depth && !command.certificate && !command.cost &&
        !command.stats && command.probes.empty()) {
        return InputError{
            .reason =
                "nothing to write: give -o OUT.png, --depth FILE.pfm, --certificate FILE.png, "
                "--cost FILE.png, --probe COL,ROW or --stats -"};
    }
    for (const auto& [option, file] :
         {std::pair("--certificate ", &command.certificate), std::pair("--cost ", &command.cost)}) {
        if (!*file || (*file)->ends_with(".png")) continue;
        return InputError{.reason = option + **file +
                                    ": the picture is a PNG; type a name that ends in .png"};
    }
    if (command.depth != "-") return std::nullopt;
    return InputError{.reason =
                          "--depth -: the depths need a file; type a name, for example depth.pfm"};
}

OrInputError<RenderPlan> plan_of(const RenderCommand& command) {
    RenderPlan plan;
    OptionReader reader;
    reader.take(plan.size, read_size("--size", command.size, in_bands));
    if (reader.error()) return std::unexpected(*reader.error());
    reader.take(plan.picture, read_picture_options(command, plan.size));
    plan.legend = !command.no_legend;
    plan.in_bands = is_drawn_in_bands(plan);
    reader.check(refused_in_bands(command, plan));
    reader.take(plan.settings, read_trace_settings(command.trace));
    if (command.repeat) {
        reader.take(plan.repeats, read_integer("--repeat", *command.repeat, 1, 100'000));
        plan.warms_up = true;
    }
    reader.take(plan.budget_s, read_budget(command.budget));
    reader.take(plan.probes, read_probes(command.probes, plan.size));
    reader.check(check_outputs(command));
    if (reader.error()) return std::unexpected(*reader.error());
    plan.fits = command.view.fit;
    plan.fits_box = !command.view.box;
    plan.quiet = command.view.quiet;
    plan.settings.costs = command.cost.has_value();
    auto input = read_document_with_rows(command.equation, command.view);
    if (!input) return std::unexpected(input.error());
    plan.fits_itself = has_free_view(*input, command.view);
    plan.document = std::move(input->document);
    plan.rows = std::move(*input->rows);
    reader.check(take_look(command.trace, plan.document));
    // Depths, certificates and counts are those of the pixels' own rays.
    if (!command.output && !command.trace.aa && !command.trace.antialias)
        plan.document.antialias = Antialias::None;
    plan.smooths_itself = input->path.empty() && !command.trace.aa && !command.trace.antialias;
    reader.check(check_jumps(plan.document, plan.settings));
    fit_camera(command.view, input->stored, plan.aspect(), plan.document);
    return reader.finish(std::move(plan));
}

Json stats_of(const RenderedPicture& picture, const RenderFiles& files) {
    const RenderPlan& plan = picture.plan;
    const Scene& scene = picture.scene;
    const PictureRequest& request = picture.request;
    const FrameTiming& timing = picture.timing;
    const Precision precision =
        frame_precision(scene, ViewFrame(request.camera), plan.settings.stop);
    Json surfaces = Json::array();
    for (const std::size_t pixels : files.surfaces())
        surfaces.push_back({{"pixels", pixels}});
    const CertificateCounts& counts = files.certificates();
    const auto width = certified_width(scene.clip, plan.settings.stop, precision);
    const int threads = plan.settings.threads > 0 ? plan.settings.threads : core_count();
    return {{"width", plan.size.width},
            {"height", plan.size.height},
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
            {"writing_ms", files.writing_ms()},
            {"certified", counts.certified},
            {"undecided", counts.undecided},
            {"miss", counts.miss},
            {"jumps", counts.jumps},
            {"undecided_not_drawn", counts.not_drawn},
            {"undecided_by_budget", timing.counters.cut_pixels},
            {"certified_coarse", counts.coarse},
            {"coarse_width", counts.coarse > 0 ? Json(timing.counters.coarse_width) : Json()},
            {"certified_width", width ? Json(*width) : Json()},
            {"contour_step",
             scene.coloring.lines.contours.empty() ? Json() : Json(scene.coloring.lines.step)},
            {"unproved_shadows", timing.counters.unproved_shadows},
            {"surfaces", surfaces},
            {"evaluations",
             {{"range", timing.counters.range},
              {"value", timing.counters.value},
              {"form", timing.counters.form}}}};
}

void print_probes(const RenderedPicture& picture) {
    const RenderPlan& plan = picture.plan;
    const Scene& scene = picture.scene;
    const PictureRequest& request = picture.request;
    const std::vector<std::size_t> shown = shown_indices(request);
    const std::vector<Kernel> typed =
        typed_formulas(*plan.rows.program, request.formula.get(), shown);
    const std::vector<std::string>& readings = plan.rows.surface_texts;
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
        const auto typed_facts = facts.transform(
            [&](const PointFacts& drawn) { return unstretched(drawn, request.camera.stretch); });
        std::cout << json_line(pixel.x, pixel.y, typed_facts, surface + 1, readings[surface]);
    }
}

/// Writes the requested files; returns an error if one cannot be written.
std::expected<void, std::string> write_files(const RenderCommand& command,
                                             const std::shared_ptr<const RenderedPicture>& made,
                                             RenderFiles& files) {
    if (!made->write_error.empty()) return std::unexpected(made->write_error);
    if (!made->plan.in_bands) {
        auto added = add_whole(command, made, files);
        if (!added) return added;
    }
    auto written = files.finish();
    if (written && command.stats)
        written = write_text(*command.stats, stats_of(*made, files).dump(2) + "\n");
    if (!written) return std::unexpected(written.error().message);
    return {};
}

int finish(const RenderCommand& command, const std::shared_ptr<const RenderedPicture>& made,
           RenderFiles& files) {
    const RenderedPicture& picture = *made;
    if (picture.error) return report(*picture.error);
    const RenderPlan& plan = picture.plan;
    if (!picture.note.empty() && plan.fits) std::cerr << "zeroset: --fit: " << picture.note << '\n';
    if (!picture.note.empty() && !plan.fits && !plan.quiet) std::cerr << fitted_note(picture.note);
    if (picture.left_plain && !plan.quiet)
        std::cerr << "zeroset: note: edges are plain, as smooth ones take long here; --aa iaa "
                     "waits for them\n";
    const std::string left = budget_note(picture);
    if (!left.empty()) std::cerr << "zeroset: " << left << '\n';
    print_probes(picture);
    const auto written = write_files(command, made, files);
    return written ? exit_ok : report_run_time(written.error());
}

}  // namespace

int run_render(const RenderCommand& command) {
    const auto start = std::chrono::steady_clock::now();
    const auto plan = plan_of(command);
    if (!plan) return report(plan.error());
    if (const auto message = first_unwritable(
            {command.output, command.depth, command.certificate, command.cost, command.stats}))
        return report_run_time(*message);
    const auto files = std::make_shared<RenderFiles>(command);
    const auto take_rows = [files](const RenderedPicture& picture, const PictureBand& band) {
        return files->add(picture, band);
    };
    const RenderOutcome outcome = render_picture(*plan, start, take_rows);
    const int exit_code = finish(command, outcome.picture, *files);
    if (outcome.stuck) end_process(exit_code);
    return exit_code;
}

}  // namespace zeroset
