#include "app/color_formulas.hpp"
#include "app/commands.hpp"
#include "app/document_scene.hpp"
#include "app/furnish.hpp"
#include "app/picture_point.hpp"
#include "app/timing.hpp"
#include "engine/image/file.hpp"
#include "engine/trace/color_range.hpp"
#include "engine/trace/extent.hpp"
#include "engine/trace/parallel.hpp"
#include "engine/trace/render.hpp"
#include "engine/trace/tolerance.hpp"
#include "engine/trace/tracer.hpp"
#include "ui/legend.hpp"
#include "ui/picture_overlay.hpp"

#include "document/framing.hpp"
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <numeric>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

/// What the options mean, checked before any work.
struct RenderPlan {
    Surface surface;
    Document document;  ///< of the surface, with what the options say of its look
    TraceSettings settings;
    Size size{};
    int repeats = 1;
    Camera camera;
    std::vector<glm::ivec2> probes;  ///< columns and rows
};

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
    }
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
    auto surface = read_surface(command.equation, command.view);
    if (!surface) return std::unexpected(surface.error());
    plan.surface = *surface;
    plan.document = document_of(*surface);
    take_look(command.trace, plan.document);
    plan.settings.shadows = plan.document.shadows;
    plan.settings.antialias = plan.document.antialias;
    const double aspect = static_cast<double>(plan.size.width) / plan.size.height;
    plan.camera = surface->camera.value_or(default_camera(surface->clip, aspect, plan.document.up));
    return plan;
}

/// The first of the files that cannot be written, as its error.
std::optional<std::string> unwritable_file(const RenderCommand& command) {
    for (const auto* path :
         {&command.output, &command.depth, &command.certificate, &command.stats}) {
        if (!*path || **path == "-") continue;
        if (auto writable = check_writable(**path); !writable) return writable.error().message;
    }
    return std::nullopt;
}

Json stats_of(const RenderPlan& plan, const Scene& scene, const Formula& formula,
              const FrameTiming& timing, const Framebuffer& frame) {
    const Precision precision = frame_precision(scene, ViewFrame(plan.camera), plan.settings.stop);
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
            {"compile_ms", formula.compile_ms},
            {"machine_code", formula.code == CodeState::Machine},
            {"precision", name_of(precision)},
            {"frame_ms",
             {{"median", timing.median_ms},
              {"min", timing.min_ms},
              {"max", timing.max_ms},
              {"repeats", timing.repeats}}},
            {"certified", counts.certified},
            {"undecided", counts.undecided},
            {"miss", counts.miss},
            {"undecided_not_drawn", counts.not_drawn},
            {"certified_coarse", counts.coarse},
            {"coarse_width", counts.coarse > 0 ? Json(timing.counters.coarse_width) : Json()},
            {"certified_width", width ? Json(*width) : Json()},
            {"surfaces", surfaces},
            {"evaluations",
             {{"range", timing.counters.range},
              {"value", timing.counters.value},
              {"form", timing.counters.form}}}};
}

/// Looks at all of the surface, if that is wanted. Says why where it cannot.
void fit(RenderPlan& plan, const RenderCommand& command, const Scene& scene) {
    if (!command.view.fit) return;
    const double aspect = static_cast<double>(plan.size.width) / plan.size.height;
    plan.document.camera = plan.camera;
    const bool may_clip = !command.view.box;
    const Framing framing = frame_surfaces(plan.document, find_extent(scene), aspect, may_clip);
    if (!framing.found) std::cerr << "zeroset: --fit: " << framing.note << '\n';
    plan.document = framing.document;
    plan.surface.clip = framing.document.clip;
    plan.camera = *framing.document.camera;
}

/// The surfaces of the formula that are shown.
std::vector<std::size_t> shown_surfaces(const Formula& formula, const RenderPlan& plan) {
    if (plan.surface.document) {
        return visible_surfaces(plan.document, surface_rows(plan.document, formula.program));
    }
    std::vector<std::size_t> all(formula.drawn.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

/// As a document has its rows, or all surfaces in the palette's colours.
Scene plain_scene(const Formula& formula, const RenderPlan& plan) {
    const Surface& surface = plan.surface;
    if (!surface.document) {
        Scene scene = make_scene(formula, surface.clip, surface.w, surface.parameters);
        scene.region = surface.region;
        return scene;
    }
    return document_scene(formula, plan.document, surface_rows(plan.document, formula.program));
}

Scene scene_of(const Formula& formula, const RenderPlan& plan, const ColorFormulas& colors) {
    Scene scene = plain_scene(formula, plan);
    scene.coloring =
        coloring_of(plan.document.coloring, colors, shown_surfaces(formula, plan), plan.camera.up);
    if (has_range(scene.coloring.by) && !scene.coloring.range) {
        scene.coloring.range =
            find_range(scene, plan.camera, plan.settings, plan.size.width, plan.size.height);
    }
    return scene;
}

/// The picture with markers and legend.
Framebuffer marked(const Framebuffer& frame, const RenderPlan& plan, const Scene& scene,
                   bool with_legend) {
    const ui::Legend legend = ui::legend_of(scene.coloring, plan.document.coloring.expression);
    const bool needs_legend = with_legend && scene.coloring.by != ColorBy::Plain;
    Framebuffer picture = frame;
    ui::draw_marks_over(picture, plan.camera, plan.document.markers,
                        needs_legend ? &legend : nullptr);
    return picture;
}

/// The reading of each of the formula's surfaces.
std::vector<std::string> surface_readings(const Formula& formula) {
    std::vector<std::string> texts;
    for (const Reading& reading : formula.program.readings) {
        if (reading.kind == StatementKind::Surface) texts.push_back(reading.text);
    }
    return texts;
}

void print_probes(const RenderPlan& plan, const Scene& scene, const Formula& formula,
                  const Framebuffer& frame) {
    const std::vector<std::size_t> shown = shown_surfaces(formula, plan);
    const std::vector<Kernel> typed = typed_formulas(formula.program, shown);
    const std::vector<std::string> readings = surface_readings(formula);
    const StopCriterion& stop = plan.settings.stop;
    const Precision precision = frame_precision(scene, ViewFrame(plan.camera), stop);
    const double tolerance = depth_tolerance(scene.clip, stop, precision);
    for (const glm::ivec2& pixel : plan.probes) {
        const auto facts =
            probe({frame, plan.camera, typed, scene.uniforms, tolerance}, pixel.x, pixel.y);
        const std::size_t surface = facts ? shown[facts->surface] : 0;
        std::cout << json_line(pixel.x, pixel.y, facts, surface + 1, readings[surface]);
    }
}

}  // namespace

int run_render(const RenderCommand& command) {
    auto plan = plan_of(command);
    if (!plan) return report(plan.error());
    if (const auto message = unwritable_file(command)) return report_run_time(*message);
    const Surface& surface = plan->surface;
    auto formula = compile_formula(surface.equation, surface.clip);
    if (!formula) return report(formula.error());
    if (const auto unknown = check_parameters(formula->program, surface.parameters)) {
        return report(*unknown);
    }
    const auto colors = color_formulas(formula->program, formula->text, plan->document.coloring);
    if (!colors) return report(color_by_error(colors.error()));
    fit(*plan, command, plain_scene(*formula, *plan));
    const Precision precision = wanted_precision(
        plain_scene(*formula, *plan), ViewFrame(plan->camera), plan->settings.stop);
    if (!formula->has_code(precision)) formula = with_double(*formula);
    const Scene scene = scene_of(*formula, *plan, *colors);
    Framebuffer frame(plan->size.width, plan->size.height);
    const FrameTiming timing = time_frames(scene, plan->camera, plan->settings, frame,
                                           plan->repeats, command.repeat.has_value());

    if (!plan->probes.empty()) print_probes(*plan, scene, *formula, frame);
    std::expected<void, FileError> written;
    if (command.output) {
        const auto painted = furnished(frame, plan->document, plan->camera);
        if (!painted) return report_run_time(painted.error());
        written = write_png(*command.output, marked(*painted, *plan, scene, !command.no_legend));
    }
    if (written && command.depth) written = write_pfm(*command.depth, frame);
    if (written && command.certificate) {
        written = write_png(*command.certificate, certificate_picture(frame));
    }
    if (written && command.stats) {
        const std::string text = stats_of(*plan, scene, *formula, timing, frame).dump(2) + "\n";
        written = write_text(*command.stats, text);
    }
    if (!written) return report_run_time(written.error().message);
    return exit_ok;
}

}  // namespace zeroset
