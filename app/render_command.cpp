#include "app/commands.hpp"
#include "app/document_scene.hpp"
#include "app/furnish.hpp"
#include "app/timing.hpp"
#include "engine/image/file.hpp"
#include "engine/trace/extent.hpp"
#include "engine/trace/parallel.hpp"
#include "engine/trace/render.hpp"
#include "engine/trace/tolerance.hpp"
#include "engine/trace/tracer.hpp"

#include "document/framing.hpp"
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>

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
};

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
    if (!command.output && !command.depth && !command.certificate && !command.stats) {
        return wrong_input(
            "nothing to write: give -o OUT.png, --depth FILE.pfm, --certificate FILE.png or "
            "--stats -");
    }
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

/// As a document has its rows, or all surfaces in the palette's colours.
Scene scene_of(const Formula& formula, const RenderPlan& plan) {
    const Surface& surface = plan.surface;
    if (!surface.document) {
        Scene scene = make_scene(formula, surface.clip, surface.w, surface.parameters);
        scene.region = surface.region;
        return scene;
    }
    return document_scene(formula, plan.document, surface_rows(plan.document, formula.program));
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
    fit(*plan, command, scene_of(*formula, *plan));
    const Precision precision =
        wanted_precision(surface.clip, ViewFrame(plan->camera), plan->settings.stop);
    if (!formula->has_code(precision)) formula = with_double(*formula);
    const Scene scene = scene_of(*formula, *plan);
    Framebuffer frame(plan->size.width, plan->size.height);
    const FrameTiming timing = time_frames(scene, plan->camera, plan->settings, frame,
                                           plan->repeats, command.repeat.has_value());

    const auto painted = furnished(frame, plan->document, plan->camera);
    if (!painted) return report_run_time(painted.error());
    std::expected<void, FileError> written;
    if (command.output) written = write_png(*command.output, *painted);
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
