#include "app/main/add_commands.hpp"
#include "app/main/add_options.hpp"
#include "pipeline/plans/export_formats.hpp"

namespace zeroset {
namespace {

/// The text with what this program cannot write of a kind behind it.
std::string with_missing(const std::string& text, ExportKind kind) {
    const std::string missing = missing_endings(kind);
    return missing.empty() ? text : text + " (" + missing + ")";
}

/// "1 to 100 for .jpg or .webp", where there are such formats.
std::string quality_range(ExportKind kind) {
    const std::string endings = export_endings(kind, &ExportFormat::quality);
    return endings.empty() ? "1 to 100, of formats that this program does not have"
                           : "1 to 100 for " + endings;
}

bool can_write(ExportKind kind, const char* name) {
    return export_format_of(kind, name)->missing.empty();
}

std::string about_film_file() {
    const std::string endings = export_endings(ExportKind::Film);
    return with_missing((endings.empty() ? "" : "a film (" + endings + "), or ") +
                            "numbered pictures: frames/f####.png",
                        ExportKind::Film);
}

/// Option texts that tell of formats are added by describe_formats.
constexpr const char* described_later = "";

void add_film_options(CLI::App& app, FilmCommand& film, const std::string& about_turn) {
    add_equation(app, film.equation);
    add_value(app, "-o,--output", film.output, described_later)->required();
    add_value(app, "--size", film.size, "WIDTHxHEIGHT in pixels (default 1280x720)");
    add_value(app, "--seconds", film.seconds, "how long it plays (default 6)");
    add_value(app, "--fps", film.fps, described_later);
    add_value(app, "--frames", film.frames,
              "N frames in all, or only those from A to B: A..B, counted from 0");
    add_value(app, "--turn", film.turn, about_turn);
    add_value(app, "--axis", film.axis, "what it turns about: x, y, z or X,Y,Z (default: up)");
    add_repeated(app, "--sweep", film.sweeps,
                 "a parameter, or w, that changes: NAME=FROM..TO; may be repeated");
    add_repeated(app, "--through", film.waypoints,
                 "where the camera goes through at constant speed: the name of a saved view, or "
                 "what --camera takes; twice or more");
    app.add_flag("--through-views", film.through_views,
                 "the camera goes through all saved views of the document, in their order");
    add_value(app, "--end", film.end,
              "loop (the last frame leads to the first), bounce (there and back) or stop");
    add_value(app, "--ease", film.ease, "linear (default) or smooth: slowly at both ends");
    add_value(app, "--blur", film.blur, "pictures that are mixed for a frame, 1 (default) to 64");
    add_value(app, "--shutter", film.shutter,
              "the part of a frame's time that --blur mixes, 0 to 1 (default 0.5)");
    add_value(app, "--frame-range", film.frame_range,
              "frames that share a search for empty space: auto (default; as many as measurement "
              "says), off, or a number");
    add_value(app, "--quality", film.quality, described_later);
    add_value(app, "--bits", film.bits, "of a color channel of numbered pictures: 8 or 16");
    app.add_flag("--alpha", film.alpha, "leave the background transparent");
    app.add_flag("--resume", film.resume,
                 "keep the numbered pictures that are there and show the same");
    app.add_flag("--no-legend", film.no_legend,
                 "leave out what says which color stands for which number");
    add_value(app, "--budget", film.budget,
              "seconds after which what is not decided of a frame stays undecided (default 30)");
    add_value(app, "--stats", film.stats, "times and counts: a JSON file, or -");
    add_view_options(app, film.view);
    add_trace_options(app, film.trace);
}

void describe(CLI::App& app, const char* subcommand, const char* option, const std::string& about) {
    app.get_subcommand(subcommand)->get_option(option)->description(about);
}

void describe_film(CLI::App& app, const char* subcommand) {
    describe(app, subcommand, "--output", about_film_file());
    describe(app, subcommand, "--fps",
             std::string("frames a second, N or N/D (default 30") +
                 (can_write(ExportKind::Film, "a.gif") ? ", for .gif 25)" : ")"));
    describe(app, subcommand, "--quality", quality_range(ExportKind::Film) + " (default 90)");
}

}  // namespace

void describe_formats(CLI::App& app) {
    describe(app, "render", "--output",
             with_missing("the picture: a file that ends in " + export_endings(ExportKind::Picture),
                          ExportKind::Picture));
    describe(app, "render", "--bits",
             "of a color channel: 8 (default) or 16 for " +
                 export_endings(ExportKind::Picture, &ExportFormat::deep));
    describe(
        app, "render", "--quality",
        quality_range(ExportKind::Picture) + " (default 92)" +
            (can_write(ExportKind::Picture, "a.webp") ? "; 100 in .webp is without loss" : ""));
    describe_film(app, "turntable");
    describe_film(app, "animate");
    describe(app, "mesh", "--output",
             "the mesh: a file that ends in " + export_endings(ExportKind::Mesh));
    describe(app, "draw", "--output",
             "the drawing: a file that ends in " + export_endings(ExportKind::Drawing));
}

CLI::App* add_render(CLI::App& app, RenderCommand& render) {
    CLI::App* const render_app = app.add_subcommand("render", "draw a picture into a file");
    add_equation(*render_app, render.equation);
    add_value(*render_app, "-o,--output", render.output, described_later);
    add_value(*render_app, "--size", render.size,
              "WIDTHxHEIGHT in pixels, up to 65536x65536 (default 1024x1024)");
    add_value(*render_app, "--bits", render.bits, described_later);
    add_value(*render_app, "--dpi", render.dpi, "dots per inch, told to printers");
    add_value(*render_app, "--quality", render.quality, described_later);
    render_app->add_flag("--no-session", render.no_session,
                         "leave out the session, which .png and .exr hold besides the picture");
    add_view_options(*render_app, render.view);
    add_trace_options(*render_app, render.trace);
    add_value(*render_app, "--depth", render.depth, "distances along the rays: a PFM file");
    add_value(*render_app, "--certificate", render.certificate,
              "what is proved of each pixel, in colors: a PNG file");
    add_value(*render_app, "--cost", render.cost,
              "evaluations of the formula that each pixel took, in colors: a PNG file");
    add_value(*render_app, "--stats", render.stats, "times and counts: a JSON file, or -");
    add_repeated(*render_app, "--probe", render.probes,
                 "print what the pixel COL,ROW shows, as a line of JSON; may be repeated");
    render_app->add_flag("--alpha", render.alpha, "leave the background transparent");
    render_app->add_flag("--no-legend", render.no_legend,
                         "leave out what says which color stands for which number");
    add_value(*render_app, "--repeat", render.repeat,
              "draw N frames after a warm-up, for timing, by machine code");
    add_value(*render_app, "--budget", render.budget,
              "seconds after which what is not decided stays undecided (default 30)");
    return render_app;
}

CLI::App* add_turntable(CLI::App& app, FilmCommand& film) {
    film.turntable = true;
    CLI::App* const film_app = app.add_subcommand("turntable", "draw a film of a full turn");
    add_film_options(*film_app, film, "degrees (default 360)");
    return film_app;
}

CLI::App* add_animate(CLI::App& app, FilmCommand& film) {
    CLI::App* const film_app =
        app.add_subcommand("animate", "draw a film of changing parameters or of a way around");
    add_film_options(*film_app, film, "turn by so many degrees on the way");
    return film_app;
}

CLI::App* add_share(CLI::App& app, ShareCommand& share) {
    CLI::App* const share_app =
        app.add_subcommand("share", "print a session as one line of text, to be sent and opened");
    add_equation(*share_app, share.equation);
    add_view_options(*share_app, share.view);
    add_trace_options(*share_app, share.trace);
    return share_app;
}

CLI::App* add_mesh(CLI::App& app, MeshCommand& mesh) {
    CLI::App* const mesh_app = app.add_subcommand("mesh", "write the surfaces as triangles");
    add_equation(*mesh_app, mesh.equation);
    add_value(*mesh_app, "-o,--output", mesh.output, described_later)->required();
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
    mesh_app->add_flag("--implicit", mesh.implicit,
                       "no triangles but the formulas themselves, as implicit functions of a .3mf "
                       "(its volumetric and implicit extensions)");
    add_value(*mesh_app, "--depth", mesh.depth,
              "the smallest cells are about the clip box's edge times 2^-N (default: no larger "
              "than the tolerance)");
    add_value(*mesh_app, "--budget", mesh.budget,
              "seconds; what is not proved or thinned by then stays so (default 30)");
    add_value(*mesh_app, "--threads", mesh.threads, "threads (default: all cores)");
    add_value(*mesh_app, "--stats", mesh.stats, "what is known of the meshes: a JSON file, or -");
    add_region_options(*mesh_app, mesh.view);
    add_color_options(*mesh_app, mesh.view.look);
    return mesh_app;
}

CLI::App* add_draw(CLI::App& app, DrawCommand& draw) {
    CLI::App* const draw_app = app.add_subcommand("draw", "draw lines into a file for a paper");
    add_equation(*draw_app, draw.equation);
    add_value(*draw_app, "-o,--output", draw.output, described_later);
    add_value(*draw_app, "--size", draw.drawing.size,
              "WIDTHxHEIGHT in points, or with mm, cm or in behind it (default 400x400)");
    add_value(*draw_app, "--lines", draw.drawing.lines,
              "which lines: all (default), or some of silhouette, crease, boundary, intersection, "
              "contour, with commas");
    add_axes_options(*draw_app, draw.trace);
    add_value(*draw_app, "--hidden", draw.drawing.hidden,
              "what surfaces hide: remove (default), dash or show");
    add_value(
        *draw_app, "--width", draw.drawing.width,
        "width of silhouettes in points, other lines are thinner (default 1); \"1; contour 0.3\": "
        "that of a kind of line, too");
    add_value(*draw_app, "--background", draw.drawing.background,
              "#RRGGBB behind the lines (default: none, so that what the drawing lies on is seen)");
    add_value(*draw_app, "--tolerance", draw.drawing.tolerance,
              "how far lines may be from the true ones, in points (default 0.05)");
    add_view_options(*draw_app, draw.view);
    add_value(*draw_app, "--stats", draw.stats, "counts of lines and proofs: a JSON file, or -");
    add_value(*draw_app, "--budget", draw.budget,
              "seconds after which no more lines are looked for (default 30)");
    return draw_app;
}

}  // namespace zeroset
