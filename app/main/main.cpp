// The command line: zeroset [EQUATION | @NAME | FILE] opens the window, zeroset SUBCOMMAND needs no
// window.

#include "app/cli/commands.hpp"
#include "app/cli/report.hpp"
#include "app/cli/window_command.hpp"
#include "app/desktop/desktop.hpp"
#include "app/main/add_commands.hpp"
#include "app/main/add_options.hpp"
#include "app/main/help.hpp"
#include "app/main/subcommands.hpp"
#include "app/platform/process.hpp"
#include "document/import/import.hpp"
#include "engine/volume/files/mapped_file.hpp"
#include "papers/tracers/paper_tracers.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {
namespace {

/// The options of the window alone.
struct WindowText {
    std::string equation;
    ViewText view;
    TraceText trace;
    bool present = false;
};

int open_window(const WindowText& text) {
    if (text.present && text.equation.empty()) {
        return report({.reason = "--present: there is nothing to be shown; type zeroset --present "
                                 "FILE.zeroset.json"});
    }
    auto options = read_desktop_options(text.equation, text.view, text.trace, TextErrors::Refused);
    if (!options) return report(options.error());
    options->tour = text.equation.empty();
    options->read_only = text.present;
    on_lost_pages(fill_lost_pages);
    const auto ran = run_desktop(*options);
    return ran ? exit_ok : report_run_time(ran.error());
}

CLI::App* add_import(CLI::App& app, ImportCommand& imports) {
    CLI::App* const import_app = app.add_subcommand(
        "import", "bring other programs' files into a folder of sessions with pictures");
    import_app->footer("Reads files that end in " + import_endings() +
                       ". What cannot be taken over goes to stderr, a line for each thing. Exit "
                       "code 2: a file could not be read.");
    import_app->add_option("FILE", imports.files, "the files; one may hold many surfaces")
        ->required();
    add_value(*import_app, "-o,--output", imports.folder, "the folder, made if need be")
        ->required();
    add_value(*import_app, "--size", imports.size, "WIDTHxHEIGHT of the pictures (default 320)");
    add_value(*import_app, "--budget", imports.budget,
              "seconds for a picture, which then stays unfinished (default 30)");
    import_app->add_flag("--no-pictures", imports.no_pictures, "sessions only");
    add_value(*import_app, "--json", imports.json, "what became of each surface, as a JSON file");
    return import_app;
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

CLI::App* add_sample(CLI::App& app, SampleCommand& sample) {
    CLI::App* const sample_app = app.add_subcommand(
        "sample", "write f, or the distance to its surface, on a grid as a volume (NRRD)");
    sample_app->footer(R"(Draw it again with "scan = volume(\"FILE.nrrd\"); scan(x,y,z) = 0".)");
    add_equation(*sample_app, sample.equation);
    add_value(*sample_app, "-o,--output", sample.output, "FILE.nrrd to write")->required();
    add_value(*sample_app, "--size", sample.size,
              "samples: NXxNYxNZ, or N along the box's longest edge (default 128)");
    add_value(*sample_app, "--box", sample.box, "L or x0,x1,y0,y1,z0,z1, as for render");
    add_value(*sample_app, "--w", sample.w, "the value of w");
    add_value(*sample_app, "--surface", sample.surface, "of several surfaces the N-th");
    sample_app->add_flag("--distance", sample.distance,
                         "the distance to the surface, negative where f < 0, in place of f");
    add_value(*sample_app, "--tolerance", sample.tolerance,
              "how far off distances may be (default: a twentieth of the spacing)");
    add_parameters(*sample_app, sample.set);
    return sample_app;
}

/// The values of all subcommands' options.
struct Commands {
    RenderCommand render;
    FilmCommand turntable, animate;
    MeshCommand mesh;
    SampleCommand sample;
    DrawCommand draw;
    ShareCommand share;
    ImportCommand imports;
    GalleryCommand gallery;
    ExplainCommand explain;
};

/// Completes what the help and the page of the command line show, which no other start needs.
void complete_help(CLI::App& app) {
    describe_formats(app);
    group_options(app);
    for (const char* const name : {"dev", "language", "command-line"})
        app.get_subcommand(name)->group("To develop Zeroset");
}

/// Adds all of them in the order of the help. `commands` must outlive the result.
std::vector<Subcommand> add_subcommands(CLI::App& app, Commands& commands) {
    Commands& c = commands;
    return {
        {add_render(app, c.render), [&c] { return run_render(c.render); }},
        {add_turntable(app, c.turntable), [&c] { return run_film(c.turntable); }},
        {add_animate(app, c.animate), [&c] { return run_film(c.animate); }},
        {add_mesh(app, c.mesh), [&c] { return run_mesh(c.mesh); }},
        {add_sample(app, c.sample), [&c] { return run_sample(c.sample); }},
        {add_draw(app, c.draw), [&c] { return run_draw(c.draw); }},
        {add_share(app, c.share), [&c] { return run_share(c.share); }},
        {add_import(app, c.imports), [&c] { return run_import(c.imports); }},
        {add_gallery(app, c.gallery), [&c] { return run_gallery(c.gallery); }},
        {add_explain(app, c.explain), [&c] { return run_explain(c.explain); }},
        {app.add_subcommand("dev", "tools to time, to compare with papers and to draw the window"),
         [] { return report({.reason = "dev stands in front: zeroset dev --help"}); }},
        {app.add_subcommand("language", "print the page of the formula language (Markdown)"),
         [] { return run_language(); }},
        {app.add_subcommand("command-line", "print the page of the command line (Markdown)"),
         [&app] {
             complete_help(app);
             print(command_line_page(app));
             return exit_ok;
         }},
    };
}

int run(int argc, char** argv) {
    add_paper_tracers();
    const std::string_view first = argc > 1 ? argv[1] : "";
    if (first == "dev") return run_dev(argc - 1, argv + 1);
    if (is_dev_tool(first)) return run_dev(argc, argv);
    CLI::App app{
        "Zeroset draws the surface f(x, y, z, w) = 0 of any formula.\n"
        "Without a subcommand it opens the window.",
        "zeroset"};
    app.require_subcommand(0, 1);
    app.set_version_flag("--version", "zeroset " ZEROSET_VERSION, "print the version and end");
    WindowText window;
    add_value(app, "EQUATION", window.equation,
              "a formula such as \"x^2 + y^2 + z^2 = 1\", @NAME of the "
              "gallery, FILE.zeroset.json, a PNG that holds a session, another program's FILE (see "
              "zeroset "
              "import --help), a FOLDER/ of files to choose from, zeroset:... as shared, or - for "
              "standard input");
    app.add_flag(
        "--present", window.present,
        "show EQUATION, a FILE mostly, to a class: the picture on the full screen with the "
        "sliders chosen for it; nothing else can be changed or saved");
    add_view_options(app, window.view);
    add_trace_options(app, window.trace);
    app.formatter(std::make_shared<HelpFormat>());
    Commands commands;
    const std::vector<Subcommand> subcommands = add_subcommands(app, commands);
    if (const auto ended = parse(app, argc, argv, complete_help)) return *ended;
    if (app.get_subcommands().empty()) return open_window(window);
    if (window.present) {
        return report({.reason = "--present opens the window: leave out " +
                                 app.get_subcommands().front()->get_name()});
    }
    return run_typed(subcommands);
}

}  // namespace
}  // namespace zeroset

int main(int argc, char** argv) {
    if (!__builtin_cpu_supports("sse4.2") || !__builtin_cpu_supports("aes") ||
        !__builtin_cpu_supports("pclmul")) {
        std::cerr << "error: Zeroset needs a processor with SSE4.2, AES and PCLMULQDQ\n";
        return zeroset::exit_run_time;
    }
    return zeroset::run(argc, argv);
}
