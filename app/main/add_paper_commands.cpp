#include "app/main/add_commands.hpp"
#include "app/main/add_options.hpp"

namespace zeroset {

CLI::App* add_compare(CLI::App& app, CompareCommand& compare) {
    CLI::App* const compare_app =
        app.add_subcommand("compare", "time the papers' algorithms beside what the papers printed");
    add_value(*compare_app, "TABLE", compare.table,
              "knoll-table-1 (default), knoll-figure-7, -8 or -9, florez-table-4.1, -5.1, -5.4, "
              "-7.1 or -7.16, florez-figure-5.13 (shadows), -6.2 (CSG), -6.8, -6.10 or -6.12 "
              "(animations), stolte-table-1, marmitt-table-1, -2, -3 or -4 (rays in voxels of a "
              "volume)");
    add_value(*compare_app, "--surface", compare.surfaces,
              "surfaces of bench's suite: A,B,... or all (default: the table's)");
    add_value(*compare_app, "--tracer", compare.tracers,
              "tracers: A,B,... or all (default: beams and the table's)");
    add_value(*compare_app, "--dstop", compare.d_stop,
              "tolerances: N,M,... (default: the table's)");
    add_value(*compare_app, "--threads", compare.threads, "threads (default: 1)");
    add_value(*compare_app, "--size", compare.size,
              "WIDTHxHEIGHT, or N for a square (default: the table's)");
    add_value(*compare_app, "--repeat", compare.repeat, "frames timed after a warm-up (default 3)");
    add_value(*compare_app, "--budget", compare.budget,
              "seconds after which a frame ends undecided (default 30)");
    add_value(*compare_app, "--json", compare.json, "also as a JSON file; - for JSON alone");
    compare_app->footer(
        "scripts/plot_compare.py draws the JSON file as a plot, scripts/papers_tables.py writes it "
        "as "
        "tables in Markdown.");
    return compare_app;
}

CLI::App* add_traversal(CLI::App& app, TraversalCommand& traversal) {
    CLI::App* const traversal_app =
        app.add_subcommand("traversal", "repeat the octrees' traversals in numbers of 128 bits");
    traversal_app->footer(
        "Prints as JSON, for octree, octree-unrounded and gargantini, how many octants were "
        "divided, on how many rays, and how many sub-octants were missed or surplus.");
    add_value(*traversal_app, "EQUATION", traversal.equation,
              "the formula, @NAME, FILE.zeroset.json, or -")
        ->required();
    add_value(*traversal_app, "--levels", traversal.levels,
              "halve the clip box so often: 10 to 53 (default 30)");
    add_value(*traversal_app, "--size", traversal.size,
              "WIDTHxHEIGHT of the rays, or N for a square (default 512)");
    add_value(*traversal_app, "--threads", traversal.threads, "threads (default: all cores)");
    add_view_options(*traversal_app, traversal.view);
    return traversal_app;
}

}  // namespace zeroset
