#include "app/dev/dev_commands.hpp"
#include "app/main/add_commands.hpp"
#include "app/main/add_options.hpp"
#include "app/main/help.hpp"
#include "app/main/subcommands.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <memory>

namespace zeroset {
namespace {

CLI::App* add_bench(CLI::App& app, BenchCommand& bench) {
    CLI::App* const bench_app = app.add_subcommand("bench", "time the suite of surfaces");
    add_value(*bench_app, "--suite", bench.suite,
              "a JSON file of surfaces (default: the gallery's)");
    add_value(*bench_app, "--tracer", bench.tracers, "tracers to compare: A,B,...");
    auto* const d_stop =
        add_value(*bench_app, "--dstop", bench.d_stop, "as for render (default 10)");
    add_value(*bench_app, "--levels", bench.levels, "as for render")->excludes(d_stop);
    add_value(*bench_app, "--threads", bench.threads, "threads (default: all cores)");
    add_value(*bench_app, "--size", bench.size, "WIDTHxHEIGHT, or N for a square (default 512)");
    add_value(*bench_app, "--repeat", bench.repeat, "frames timed after a warm-up (default 5)");
    bench_app->add_flag("--shadows", bench.shadows, "let the surfaces throw shadows");
    auto* const smooth =
        bench_app->add_flag("--antialias", bench.antialias, "smooth edges: --aa iaa");
    add_value(*bench_app, "--aa", bench.aa, "smooth edges: iaa, none, or 4, 9, 16, 64 rays a pixel")
        ->excludes(smooth);
    add_value(*bench_app, "--look", bench.light.look, "as for render (default standard)");
    add_value(*bench_app, "--reflections", bench.light.reflections,
              "how often a ray is mirrored, 0 (default) to 5");
    add_value(*bench_app, "--budget", bench.budget,
              "seconds after which a frame ends undecided (default 30)");
    add_value(*bench_app, "--json", bench.json, "also as a JSON file; - for JSON alone");
    bench_app->add_flag("--first-picture", bench.first_picture,
                        "time the window's way from an edit to its first picture instead, of all "
                        "of the gallery; without --json, --budget and light");
    return bench_app;
}

CLI::App* add_ui_shot(CLI::App& app, UiShotCommand& shot) {
    CLI::App* const shot_app = app.add_subcommand("ui-shot", "draw the window into a file");
    shot_app->footer(
        "Needs no display. An error in the equation is drawn as the window shows it: the exit code "
        "is 0.");
    add_value(*shot_app, "EQUATION", shot.equation,
              "the formula, @NAME, FILE.zeroset.json, or - (default: the gallery's first)");
    add_value(*shot_app, "-o,--output", shot.output, "the picture: a PNG file");
    add_value(*shot_app, "--size", shot.size,
              "WIDTHxHEIGHT of the window at scale 1 (default 1280x800)");
    add_value(*shot_app, "--scale", shot.scale, "pixels per unit of the size, 1 to 4 (default 1)");
    add_value(*shot_app, "--theme", shot.theme, "dark (default) or light");
    add_value(*shot_app, "--language", shot.language,
              "of the window's texts: en (default), de, fr or es");
    add_value(*shot_app, "--pointer", shot.pointer,
              "where the pointer rests: X,Y from the left and the top, at scale 1");
    add_repeated(*shot_app, "--do", shot.actions,
                 "the name of an action (Ctrl+K lists them), such as Gallery; may be repeated");
    shot_app->add_flag("--mark-undecided", shot.mark_undecided, "tint the undecided pixels");
    add_view_options(*shot_app, shot.view);
    add_trace_options(*shot_app, shot.trace);
    return shot_app;
}

CLI::App* add_latency(CLI::App& app, LatencyCommand& latency) {
    CLI::App* const latency_app = app.add_subcommand(
        "latency", "open the window, and write how long each input took to change the picture");
    add_value(*latency_app, "EQUATION", latency.equation,
              "the formula, @NAME, FILE.zeroset.json, or - (default: the gallery's first)");
    add_value(*latency_app, "-o,--output", latency.output, "a file of JSON lines")->required();
    add_view_options(*latency_app, latency.view);
    add_trace_options(*latency_app, latency.trace);
    return latency_app;
}

/// The values of all tools' options.
struct DevCommands {
    BenchCommand bench;
    UiShotCommand shot;
    LatencyCommand latency;
    PaperCommands papers;
};

}  // namespace

bool is_dev_tool(std::string_view word) {
    constexpr std::array<std::string_view, 4> tools{"bench", "ui-shot", "compare", "traversal"};
    return std::ranges::find(tools, word) != tools.end();
}

int run_dev(int argc, char** argv) {
    CLI::App app{"Tools to develop Zeroset.", "zeroset dev"};
    app.require_subcommand(1);
    app.formatter(std::make_shared<HelpFormat>());
    DevCommands c;
    const std::vector<Subcommand> subcommands{
        {add_bench(app, c.bench), [&c] { return run_bench(c.bench); }},
        {add_ui_shot(app, c.shot), [&c] { return run_ui_shot(c.shot); }},
        {add_latency(app, c.latency), [&c] { return run_latency(c.latency); }},
        {add_compare(app, c.papers.compare), [&c] { return run_compare(c.papers.compare); }},
        {add_traversal(app, c.papers.traversal),
         [&c] { return run_traversal(c.papers.traversal); }},
    };
    if (const auto ended = parse(app, argc, argv, group_options)) return *ended;
    return run_typed(subcommands);
}

}  // namespace zeroset
