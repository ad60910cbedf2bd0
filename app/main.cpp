// The command line: zeroset [EQUATION | @NAME] opens the window, zeroset SUBCOMMAND needs none.

#include "app/commands.hpp"
#include "app/desktop.hpp"
#include "app/gallery.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <string>
#include <vector>

namespace zeroset {
namespace {

void add_view_options(CLI::App& app, ViewText& view) {
    app.add_option("--box", view.box, "clip box: L for [-L,L]^3, or x0,x1,y0,y1,z0,z1 (default 2)");
    app.add_option("--eye", view.eye, "where the eye is: x,y,z");
    app.add_option("--look-at", view.look_at, "the point looked at: x,y,z");
    app.add_option("--up", view.up, "the direction that is up: x,y,z (default 0,0,1)");
    app.add_option("--fov", view.fov, "vertical field of view in degrees (default 42)");
    app.add_option("--w", view.w, "value of the variable w (default 0)");
}

void add_trace_options(CLI::App& app, TraceText& trace) {
    app.add_option("--tracer", trace.tracer, "how roots are found: k-bisection");
    auto* const d_stop = app.add_option(
        "--dstop", trace.d_stop, "stop at cells of the clip box's edge times 2^-N (default 22)");
    auto* const epsilon = app.add_option("--epsilon", trace.epsilon,
                                         "stop at boxes with a diagonal below E, world units");
    auto* const delta =
        app.add_option("--delta", trace.delta, "stop where the enclosure of f is narrower than D");
    d_stop->excludes(epsilon)->excludes(delta);
    epsilon->excludes(delta);
    app.add_option("--threads", trace.threads, "threads (default: all cores)");
}

/// "-x^2+y" is an equation: the parser of the command line takes words with a leading space for
/// values, and the readers of values drop it.
std::vector<std::string> protected_arguments(int argc, char** argv) {
    std::vector<std::string> arguments(argv + 1, argv + argc);
    for (std::string& argument : arguments) {
        const bool dash = argument.size() > 1 && argument[0] == '-' && argument[1] != '-';
        const bool flag = argument == "-h" || argument.starts_with("-o");
        if (dash && !flag) argument.insert(0, 1, ' ');
    }
    return {arguments.rbegin(), arguments.rend()};
}

int open_window(const std::string& equation, const ViewText& view, const TraceText& trace) {
    const std::string first = "@" + gallery().front().name;
    const auto surface = read_surface(equation.empty() ? first : equation, view);
    if (!surface) return report(surface.error());
    auto settings = read_trace_settings(trace);
    if (!settings) return report(settings.error());
    const bool stop_given = trace.d_stop || trace.epsilon || trace.delta;
    constexpr double interactive_d_stop = 14.0;
    if (!stop_given) settings->stop.value = interactive_d_stop;
    return run_desktop({surface->equation, surface->clip, surface->w, surface->camera, *settings});
}

int run(int argc, char** argv) {
    CLI::App app{
        "Zeroset draws the surface f(x, y, z, w) = 0 of any formula.\n"
        "Without a subcommand it opens the window."};
    app.require_subcommand(0, 1);
    std::string equation;
    ViewText view;
    TraceText trace;
    app.add_option("EQUATION", equation,
                   "a formula such as \"x^2 + y^2 + z^2 = 1\", @NAME of the "
                   "gallery, or - for standard input");
    add_view_options(app, view);
    add_trace_options(app, trace);

    RenderCommand render;
    CLI::App* const render_app = app.add_subcommand("render", "draw a picture into a file");
    render_app->add_option("EQUATION", render.equation, "the formula, @NAME, or -")->required();
    render_app->add_option("-o,--output", render.output, "the picture: a PNG file");
    render_app->add_option("--size", render.size, "WIDTHxHEIGHT in pixels (default 1024x1024)");
    add_view_options(*render_app, render.view);
    add_trace_options(*render_app, render.trace);
    render_app->add_option("--depth", render.depth, "distances along the rays: a PFM file");
    render_app->add_option("--stats", render.stats, "times and counts: a JSON file, or -");
    render_app->add_option("--repeat", render.repeat, "draw N frames after a warm-up, for timing");

    GalleryCommand gallery_command;
    CLI::App* const gallery_app = app.add_subcommand("gallery", "list the gallery");
    gallery_app->add_flag("--names", gallery_command.names, "only the names, one a line");
    gallery_app->add_flag("--json", gallery_command.json, "as JSON");

    ExplainCommand explain;
    CLI::App* const explain_app = app.add_subcommand("explain", "show how a formula is read");
    explain_app->add_option("EQUATION", explain.equation, "the formula, @NAME, or -")->required();
    explain_app->add_option("--at", explain.at, "also f and its gradient at x,y,z or x,y,z,w");
    explain_app->add_flag("--ir", explain.ir, "also the LLVM IR");
    explain_app->add_flag("--asm", explain.assembly, "also the machine code's assembly");
    explain_app->add_flag("--json", explain.json, "as JSON");

    BenchCommand bench;
    CLI::App* const bench_app = app.add_subcommand("bench", "time the suite of surfaces");
    bench_app->add_option("--suite", bench.suite,
                          "a JSON file of surfaces (default: the gallery's)");
    bench_app->add_option("--tracer", bench.tracers, "tracers to compare: A,B,...");
    bench_app->add_option("--dstop", bench.d_stop, "as for render (default 10)");
    bench_app->add_option("--threads", bench.threads, "threads (default: all cores)");
    bench_app->add_option("--size", bench.size, "WIDTHxHEIGHT, or N for a square (default 512)");
    bench_app->add_option("--repeat", bench.repeat, "frames timed after a warm-up (default 5)");
    bench_app->add_option("--json", bench.json, "also as a JSON file; - for JSON alone");

    try {
        app.parse(protected_arguments(argc, argv));
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return report({std::string(error.what()) + " (zeroset --help lists what there is)",
                       std::nullopt,
                       {}});
    }
    if (*render_app) return run_render(render);
    if (*gallery_app) return run_gallery(gallery_command);
    if (*explain_app) return run_explain(explain);
    if (*bench_app) return run_bench(bench);
    return open_window(equation, view, trace);
}

}  // namespace
}  // namespace zeroset

int main(int argc, char** argv) {
    if (!__builtin_cpu_supports("sse4.2")) {
        std::cerr << "error: Zeroset needs a processor with SSE4.2\n";
        return zeroset::exit_run_time;
    }
    return zeroset::run(argc, argv);
}
