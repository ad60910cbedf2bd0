// The command line: zeroset [EQUATION | @NAME | FILE] opens the window, zeroset SUBCOMMAND needs no
// window.

#include "app/cli/commands.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/report.hpp"
#include "app/cli/window_command.hpp"
#include "app/desktop/desktop.hpp"
#include "app/platform/process.hpp"
#include "engine/base/text.hpp"
#include "engine/draw/files/formats.hpp"
#include "engine/export/file.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {
namespace {

/// Adds an option with a value; spaces at both ends of the value are dropped.
template <class Value>
CLI::Option* add_value(CLI::App& app, const std::string& names, Value& value,
                       const std::string& about) {
    const std::function<std::string(std::string)> trim = [](const std::string& text) {
        return std::string(trimmed(text));
    };
    return app.add_option(names, value, about)->transform(trim);
}

/// Adds the pair --NAME and --no-NAME.
CLI::Option* add_switch(CLI::App& app, const std::string& name, std::optional<bool>& value,
                        const std::string& about) {
    const std::function<void(std::int64_t)> take = [&value](std::int64_t count) {
        value = count > 0;
    };
    return app.add_flag_function("--" + name + ",!--no-" + name, take, about);
}

void add_repeated(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                  const std::string& about) {
    app.add_option(name, values, about)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_color_options(CLI::App& app, LookText& look) {
    add_value(app, "--color-by", look.color_by,
              "what colours tell: plain, normal, height, depth, mean-curvature, "
              "gaussian-curvature, gradient, or an expression in x, y, z, w and the parameters");
    add_value(app, "--color-range", look.color_range,
              "the numbers at the ends of the colours: A,B, or auto (default)");
    add_value(app, "--color-map", look.color_map, "aurora, ember, balance, gray or cycle");
}

void add_look_options(CLI::App& app, LookText& look) {
    add_color_options(app, look);
    add_value(app, "--contours", look.contours,
              "contour lines: height, xyz (the coordinates' grid), an expression, or none; then, "
              "each after a ;, step S and width PIXELS");
    add_switch(app, "intersections", look.intersections, "draw lines where two surfaces meet");
    add_repeated(app, "--mark", look.marks, "a marker at x,y,z; may be repeated");
}

void add_parameters(CLI::App& app, std::vector<std::string>& set) {
    add_repeated(app, "--set", set,
                 "value of a parameter: NAME=VALUE (default 1); may be repeated");
}

/// Adds the options for what of the surfaces there is.
void add_region_options(CLI::App& app, ViewText& view) {
    add_value(app, "--box", view.box, "clip box: L for [-L,L]^3, or x0,x1,y0,y1,z0,z1 (default 2)");
    add_value(app, "--sphere", view.sphere,
              "shows only what is in a sphere: R about the origin, or x,y,z,R");
    app.add_option("--section", view.sections,
                   "cuts by a plane and keeps one side: x<0.3, y>0, z=1 (the side away from the "
                   "eye), or nx,ny,nz,d for nx x + ny y + nz z <= d; may be repeated")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_repeated(app, "--solid", view.solids,
                 "the side that is solid, which sections fill: f<0, f>0 or auto (default), of all "
                 "surfaces or of one: 2:f>0; may be repeated");
    add_value(app, "--w", view.w, "value of the variable w (default 0)");
    add_parameters(app, view.set);
}

void add_view_options(CLI::App& app, ViewText& view) {
    add_region_options(app, view);
    add_value(app, "--eye", view.eye, "where the eye is: x,y,z");
    add_value(app, "--look-at", view.look_at, "the point looked at: x,y,z");
    add_value(app, "--up", view.up, "the direction that is up: x,y,z (default 0,0,1)");
    add_value(app, "--fov", view.fov, "vertical field of view in degrees (default 42)");
    add_value(app, "--projection", view.projection, "perspective (default) or orthographic");
    app.add_flag("--hollow", view.hollow, "do not fill the solids that sections cut open");
    add_repeated(app, "--opacity", view.opacities,
                 "how opaque surfaces are, 0 to 1, all or one: 2:0.5; may be repeated");
    app.add_flag("--fit", view.fit,
                 "look at all of the surface; without --box the clip box follows it, too");
    add_look_options(app, view.look);
}

void add_light_options(CLI::App& app, LightText& light) {
    add_value(app, "--look", light.look,
              "standard (default), matte, porcelain, metal, glass, clay or technical");
    add_repeated(app, "--light", light.lights,
                 "a light instead of the look's own: X,Y,Z towards it, or camera X,Y,Z (right, up, "
                 "back); then, each after a ;, power P, size DEGREES (soft shadows), color "
                 "#RRGGBB; up to four times");
    add_value(app, "--reflections", light.reflections,
              "how often a ray is mirrored, 0 (default) to 5");
    add_value(app, "--absorption", light.absorption,
              "how much of other colours solids swallow of what is seen through them, per unit of "
              "length (default 0)");
    add_value(app, "--background", light.background,
              "#RRGGBB, #RRGGBB,#RRGGBB from top to bottom, or default");
    add_value(app, "--tone", light.tone, "bright light: plain (default, cut off) or filmic");
}

void add_trace_options(CLI::App& app, TraceText& trace) {
    add_value(app, "--tracer", trace.tracer, "how roots are found: beams (default) or k-bisection");
    auto* const d_stop =
        add_value(app, "--dstop", trace.d_stop,
                  "stop at cells of the clip box's edge times 2^-N (default 22, in the window 14)");
    auto* const epsilon = add_value(app, "--epsilon", trace.epsilon,
                                    "stop at boxes with a diagonal below E, world units");
    auto* const delta =
        add_value(app, "--delta", trace.delta, "stop where the enclosure of f is narrower than D");
    d_stop->excludes(epsilon)->excludes(delta);
    epsilon->excludes(delta);
    add_value(app, "--threads", trace.threads, "threads (default: all cores)");
    add_switch(app, "shadows", trace.shadows, "let the surfaces throw shadows");
    auto* const smooth = add_switch(app, "antialias", trace.antialias, "smooth edges: --aa iaa");
    add_value(app, "--aa", trace.aa,
              "smooth edges: iaa (exact, by beams), none, or 4, 9, 16, 64 rays a pixel")
        ->excludes(smooth);
    add_light_options(app, trace.light);
    add_switch(app, "jumps", trace.jumps, "draw also where f changes its sign in a jump");
    add_switch(app, "axes", trace.axes, "draw axes with numbers");
    add_switch(app, "clip-box", trace.clip_box, "draw the clip box's edges");
    add_switch(app, "grid", trace.grid, "draw a grid on the clip box's floor");
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
    add_value(*shot_app, "--pointer", shot.pointer,
              "where the pointer rests: X,Y from the left and the top, at scale 1");
    add_repeated(*shot_app, "--do", shot.actions,
                 "the name of an action (Ctrl+K lists them), such as Gallery; may be repeated");
    shot_app->add_flag("--mark-undecided", shot.mark_undecided, "tint the undecided pixels");
    add_view_options(*shot_app, shot.view);
    add_trace_options(*shot_app, shot.trace);
    return shot_app;
}

/// Puts a space before arguments such as "-x^2+y", which are equations: CLI11 takes words with a
/// leading space for values, and the readers of values drop the space.
std::vector<std::string> protected_arguments(int argc, char** argv) {
    std::vector<std::string> arguments(argv + 1, argv + argc);
    for (std::string& argument : arguments) {
        const bool dash = argument.size() > 1 && argument[0] == '-' && argument[1] != '-';
        const bool flag = argument == "-h" || argument.starts_with("-o");
        if (dash && !flag) argument.insert(0, 1, ' ');
    }
    return {arguments.rbegin(), arguments.rend()};
}

int open_window(const std::string& equation, const ViewText& view, const TraceText& trace,
                const std::string& latency_log) {
    auto options = read_desktop_options(equation, view, trace, TextErrors::Refused);
    if (!options) return report(options.error());
    if (!latency_log.empty()) {
        const auto writable = check_writable(latency_log);
        if (!writable) return report_run_time(writable.error().message);
        options->latency_log = latency_log;
    }
    const auto ran = run_desktop(*options);
    return ran ? exit_ok : report_run_time(ran.error());
}

CLI::App* add_render(CLI::App& app, RenderCommand& render) {
    CLI::App* const render_app = app.add_subcommand("render", "draw a picture into a file");
    add_value(*render_app, "EQUATION", render.equation,
              "the formula, @NAME, FILE.zeroset.json, a PNG of ours, zeroset:..., or -")
        ->required();
    add_value(*render_app, "-o,--output", render.output,
              "the picture: a file that ends in .png, .jpg, .webp, .tif or .exr");
    add_value(*render_app, "--size", render.size,
              "WIDTHxHEIGHT in pixels, up to 65536x65536 (default 1024x1024)");
    add_value(*render_app, "--bits", render.bits,
              "of a colour channel: 8 (default) or 16 for .png and .tif");
    add_value(*render_app, "--dpi", render.dpi, "dots per inch, told to printers");
    add_value(*render_app, "--quality", render.quality,
              "1 to 100 for .jpg and .webp (default 92); 100 in .webp is without loss");
    render_app->add_flag("--no-session", render.no_session,
                         "leave out the session, which .png and .exr hold besides the picture");
    add_view_options(*render_app, render.view);
    add_trace_options(*render_app, render.trace);
    add_value(*render_app, "--depth", render.depth, "distances along the rays: a PFM file");
    add_value(*render_app, "--certificate", render.certificate,
              "what is proved of each pixel, in colours: a PNG file");
    add_value(*render_app, "--stats", render.stats, "times and counts: a JSON file, or -");
    add_repeated(*render_app, "--probe", render.probes,
                 "print what the pixel COL,ROW shows, as a line of JSON; may be repeated");
    render_app->add_flag("--alpha", render.alpha, "leave the background transparent");
    render_app->add_flag("--no-legend", render.no_legend,
                         "leave out what says which colour stands for which number");
    add_value(*render_app, "--repeat", render.repeat,
              "draw N frames after a warm-up, for timing, by machine code");
    add_value(*render_app, "--budget", render.budget,
              "seconds after which what is not decided stays undecided (default 30)");
    return render_app;
}

void add_film_options(CLI::App& app, FilmCommand& film) {
    add_value(app, "EQUATION", film.equation,
              "the formula, @NAME, FILE.zeroset.json, a PNG of ours, zeroset:..., or -")
        ->required();
    add_value(app, "-o,--output", film.output,
              "a film (.mp4, .webm, .mov, .mkv, .gif or .apng), or numbered pictures: "
              "frames/f####.png")
        ->required();
    add_value(app, "--size", film.size, "WIDTHxHEIGHT in pixels (default 1280x720)");
    add_value(app, "--seconds", film.seconds, "how long it plays (default 6)");
    add_value(app, "--fps", film.fps, "frames a second, N or N/D (default 30, for .gif 25)");
    add_value(app, "--frames", film.frames,
              "N frames in all, or only those from A to B: A..B, counted from 0");
    add_value(app, "--axis", film.axis, "what it turns about: x, y, z or X,Y,Z (default: up)");
    add_repeated(app, "--sweep", film.sweeps,
                 "a parameter, or w, that changes: NAME=FROM..TO; may be repeated");
    add_repeated(app, "--through", film.waypoints,
                 "where the camera goes through at constant speed: eye X,Y,Z, and each after a ;, "
                 "look-at X,Y,Z, up X,Y,Z, fov DEGREES; twice or more");
    add_value(app, "--end", film.end,
              "loop (the last frame leads to the first), bounce (there and back) or stop");
    add_value(app, "--ease", film.ease, "linear (default) or smooth: slowly at both ends");
    add_value(app, "--blur", film.blur, "pictures that are mixed for a frame, 1 (default) to 64");
    add_value(app, "--shutter", film.shutter,
              "the part of a frame's time that --blur mixes, 0 to 1 (default 0.5)");
    add_value(app, "--quality", film.quality, "1 to 100 for .mp4 and .webm (default 90)");
    add_value(app, "--bits", film.bits, "of a colour channel of numbered pictures: 8 or 16");
    app.add_flag("--alpha", film.alpha, "leave the background transparent");
    app.add_flag("--resume", film.resume,
                 "keep the numbered pictures that are there and show the same");
    app.add_flag("--no-legend", film.no_legend,
                 "leave out what says which colour stands for which number");
    add_value(app, "--budget", film.budget,
              "seconds after which what is not decided of a frame stays undecided (default 30)");
    add_value(app, "--stats", film.stats, "times and counts: a JSON file, or -");
    add_view_options(app, film.view);
    add_trace_options(app, film.trace);
}

CLI::App* add_turntable(CLI::App& app, FilmCommand& film) {
    film.turntable = true;
    CLI::App* const film_app = app.add_subcommand("turntable", "draw a film of a full turn");
    add_value(*film_app, "--turn", film.turn, "degrees (default 360)");
    add_film_options(*film_app, film);
    return film_app;
}

CLI::App* add_animate(CLI::App& app, FilmCommand& film) {
    CLI::App* const film_app =
        app.add_subcommand("animate", "draw a film of changing parameters or of a way around");
    add_value(*film_app, "--turn", film.turn, "turn by so many degrees on the way");
    add_film_options(*film_app, film);
    return film_app;
}

CLI::App* add_share(CLI::App& app, ShareCommand& share) {
    CLI::App* const share_app =
        app.add_subcommand("share", "print a session as one line of text, to be sent and opened");
    add_value(*share_app, "EQUATION", share.equation,
              "the formula, @NAME, FILE.zeroset.json, a PNG of ours, or -")
        ->required();
    add_view_options(*share_app, share.view);
    add_trace_options(*share_app, share.trace);
    return share_app;
}

CLI::App* add_mesh(CLI::App& app, MeshCommand& mesh) {
    CLI::App* const mesh_app =
        app.add_subcommand("mesh", "write the surfaces as triangles: STL, 3MF, PLY, OBJ, glTF");
    add_value(*mesh_app, "EQUATION", mesh.equation, "the formula, @NAME, FILE.zeroset.json, or -")
        ->required();
    add_value(*mesh_app, "-o,--output", mesh.output,
              "the file: its ending, .stl, .3mf, .ply, .obj or .glb, says the format")
        ->required();
    add_value(*mesh_app, "--tolerance", mesh.tolerance,
              "how far triangles may be from the surface, world units (default: a thousandth of "
              "the clip box's longest edge)");
    add_value(*mesh_app, "--size", mesh.size,
              "millimetres of the longest edge of what is written (default 100)");
    add_value(*mesh_app, "--triangles", mesh.triangles,
              "at most about so many for each surface: raises the tolerance until they suffice");
    add_value(*mesh_app, "--wall", mesh.wall,
              "make a wall of so many millimetres of each surface, open where the box ends it");
    add_value(*mesh_app, "--surface", mesh.surface, "only the surface of this number, from 1 on");
    mesh_app->add_flag("--open", mesh.open,
                       "the surface alone, not closed where the box, sections "
                       "and its bounds end it");
    mesh_app->add_flag("--no-thin", mesh.no_thin,
                       "keep all triangles: the mesh that the proof is about");
    add_value(*mesh_app, "--depth", mesh.depth,
              "the smallest cells are about the clip box's edge times 2^-N (default: no larger "
              "than the tolerance)");
    add_value(*mesh_app, "--budget", mesh.budget,
              "seconds after which cells are divided no more (default 30)");
    add_value(*mesh_app, "--threads", mesh.threads, "threads (default: all cores)");
    add_value(*mesh_app, "--stats", mesh.stats, "what is known of the meshes: a JSON file, or -");
    add_region_options(*mesh_app, mesh.view);
    add_color_options(*mesh_app, mesh.view.look);
    return mesh_app;
}

CLI::App* add_draw(CLI::App& app, DrawCommand& draw) {
    CLI::App* const draw_app = app.add_subcommand("draw", "draw lines into a file for a paper");
    add_value(*draw_app, "EQUATION", draw.equation, "the formula, @NAME, FILE.zeroset.json, or -")
        ->required();
    add_value(*draw_app, "-o,--output", draw.output, "the drawing: " + drawing_format_list());
    add_value(*draw_app, "--size", draw.drawing.size,
              "WIDTHxHEIGHT in points, or with mm, cm or in behind it (default 400x400)");
    add_value(*draw_app, "--lines", draw.drawing.lines,
              "which lines: all (default), or some of silhouette, crease, boundary, intersection, "
              "contour, with commas");
    add_value(*draw_app, "--hidden", draw.drawing.hidden,
              "what surfaces hide: remove (default), dash or show");
    add_value(*draw_app, "--width", draw.drawing.width,
              "width of silhouettes in points; other lines are thinner (default 1)");
    add_value(*draw_app, "--tolerance", draw.drawing.tolerance,
              "how far lines may be from the true ones, in points (default 0.05)");
    add_view_options(*draw_app, draw.view);
    add_value(*draw_app, "--stats", draw.stats, "counts of lines and proofs: a JSON file, or -");
    add_value(*draw_app, "--budget", draw.budget,
              "seconds after which no more lines are looked for (default 30)");
    return draw_app;
}

CLI::App* add_gallery(CLI::App& app, GalleryCommand& gallery) {
    CLI::App* const gallery_app = app.add_subcommand("gallery", "list the gallery");
    gallery_app->add_flag("--names", gallery.names, "only the names, one a line");
    gallery_app->add_flag("--json", gallery.json, "as JSON");
    return gallery_app;
}

CLI::App* add_explain(CLI::App& app, ExplainCommand& explain) {
    CLI::App* const explain_app = app.add_subcommand("explain", "show how a formula is read");
    add_value(*explain_app, "EQUATION", explain.equation, "the formula, @NAME, or -")->required();
    add_value(*explain_app, "--at", explain.at, "also f and its gradient at x,y,z or x,y,z,w");
    add_parameters(*explain_app, explain.set);
    explain_app->add_flag("--ir", explain.ir, "also the LLVM IR");
    explain_app->add_flag("--asm", explain.assembly, "also the machine code's assembly");
    explain_app->add_flag("--json", explain.json, "as JSON");
    return explain_app;
}

CLI::App* add_bench(CLI::App& app, BenchCommand& bench) {
    CLI::App* const bench_app = app.add_subcommand("bench", "time the suite of surfaces");
    add_value(*bench_app, "--suite", bench.suite,
              "a JSON file of surfaces (default: the gallery's)");
    add_value(*bench_app, "--tracer", bench.tracers, "tracers to compare: A,B,...");
    add_value(*bench_app, "--dstop", bench.d_stop, "as for render (default 10)");
    add_value(*bench_app, "--threads", bench.threads, "threads (default: all cores)");
    add_value(*bench_app, "--size", bench.size, "WIDTHxHEIGHT, or N for a square (default 512)");
    add_value(*bench_app, "--repeat", bench.repeat, "frames timed after a warm-up (default 5)");
    bench_app->add_flag("--shadows", bench.shadows, "let the surfaces throw shadows");
    auto* const smooth =
        bench_app->add_flag("--antialias", bench.antialias, "smooth edges: --aa iaa");
    add_value(*bench_app, "--aa", bench.aa, "smooth edges: iaa, none, or 4, 9, 16, 64 rays a pixel")
        ->excludes(smooth);
    add_value(*bench_app, "--budget", bench.budget,
              "seconds after which a frame ends undecided (default 30)");
    add_value(*bench_app, "--json", bench.json, "also as a JSON file; - for JSON alone");
    bench_app->add_flag("--first-picture", bench.first_picture,
                        "time the window's way from an edit to its first picture instead, of all "
                        "of the gallery; without --json, --budget and light");
    return bench_app;
}

int run(int argc, char** argv) {
    CLI::App app{
        "Zeroset draws the surface f(x, y, z, w) = 0 of any formula.\n"
        "Without a subcommand it opens the window.",
        "zeroset"};
    app.require_subcommand(0, 1);
    app.set_version_flag("--version", "zeroset " ZEROSET_VERSION, "print the version and end");
    std::string equation;
    ViewText view;
    TraceText trace;
    add_value(
        app, "EQUATION", equation,
        "a formula such as \"x^2 + y^2 + z^2 = 1\", @NAME of the "
        "gallery, FILE.zeroset.json, a PNG that holds a session, zeroset:... as shared, or - for "
        "standard input");
    add_view_options(app, view);
    add_trace_options(app, trace);
    std::string latency_log;
    add_value(app, "--latency-log", latency_log,
              "a file of JSON lines: how long each input took to change the picture");
    RenderCommand render;
    DrawCommand draw;
    UiShotCommand shot;
    FilmCommand turntable;
    FilmCommand animate;
    ShareCommand share;
    MeshCommand mesh;
    GalleryCommand gallery;
    ExplainCommand explain;
    BenchCommand bench;
    const CLI::App* const language_app =
        app.add_subcommand("language", "print the page of the formula language (Markdown)");
    const CLI::App* const render_app = add_render(app, render);
    const CLI::App* const mesh_app = add_mesh(app, mesh);
    const CLI::App* const draw_app = add_draw(app, draw);
    const CLI::App* const shot_app = add_ui_shot(app, shot);
    const CLI::App* const turntable_app = add_turntable(app, turntable);
    const CLI::App* const animate_app = add_animate(app, animate);
    const CLI::App* const share_app = add_share(app, share);
    const CLI::App* const gallery_app = add_gallery(app, gallery);
    const CLI::App* const explain_app = add_explain(app, explain);
    const CLI::App* const bench_app = add_bench(app, bench);
    try {
        app.parse(protected_arguments(argc, argv));
    } catch (const CLI::Success& answer) {  // --help and --version
        return app.exit(answer);
    } catch (const CLI::ParseError& error) {
        return report(
            {.reason = std::string(error.what()) + " (zeroset --help lists what there is)"});
    }
    if (!app.get_subcommands().empty()) end_on_signals(clear_progress);
    if (*render_app) return run_render(render);
    if (*mesh_app) return run_mesh(mesh);
    if (*shot_app) return run_ui_shot(shot);
    if (*turntable_app) return run_film(turntable);
    if (*animate_app) return run_film(animate);
    if (*share_app) return run_share(share);
    if (*gallery_app) return run_gallery(gallery);
    if (*explain_app) return run_explain(explain);
    if (*draw_app) return run_draw(draw);
    if (*bench_app) return run_bench(bench);
    if (*language_app) return run_language();
    return open_window(equation, view, trace, latency_log);
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
