#include "app/cli/options/option_reader.hpp"
#include "app/cli/report.hpp"
#include "app/cli/timing.hpp"
#include "app/dev/bench_suite.hpp"
#include "app/dev/dev_commands.hpp"
#include "engine/base/clock.hpp"
#include "engine/base/parallel.hpp"
#include "engine/base/text.hpp"
#include "engine/export/file.hpp"
#include "engine/render/known_frame.hpp"
#include "engine/render/tracers.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string_view>
#include <utility>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

struct BenchPlan {
    std::vector<BenchItem> items;
    std::vector<TraceSettings> settings;  ///< one for each tracer
    LightChoice light;
    Size size{};
    int repeats = 5;
    double budget_s = default_budget_s;  ///< for each frame
};

/// Size of the picture, without the panel, in the window at its first size.
constexpr const char* size_in_window = "902x773";

/// Returns an error for an option that --first-picture would ignore.
std::optional<InputError> check_first_picture(const BenchCommand& command) {
    const std::string has = "--first-picture has ";
    if (command.json)
        return InputError{.reason = has + "no --json; leave it out, the table is printed"};
    for (const auto& [option, given] : {std::pair{"--budget", command.budget.has_value()},
                                        {"--shadows", command.shadows},
                                        {"--antialias", command.antialias},
                                        {"--levels", command.levels.has_value()},
                                        {"--aa", command.aa.has_value()},
                                        {"--look", command.light.look.has_value()},
                                        {"--reflections", command.light.reflections.has_value()}}) {
        if (given) return InputError{.reason = has + "no " + option + "; leave it out"};
    }
    if (!command.tracers || !command.tracers->contains(',')) return std::nullopt;
    return InputError{.reason = has + "one --tracer; type " + std::string(usual_tracer().name)};
}

OrInputError<BenchPlan> plan_of(const BenchCommand& command) {
    BenchPlan plan;
    if (const auto wrong = command.first_picture ? check_first_picture(command) : std::nullopt)
        return std::unexpected(*wrong);
    Antialias antialias{};
    OptionReader reader;
    reader.take(antialias, read_antialias(command.aa.value_or(command.antialias ? "iaa" : "none")));
    const std::string usual = command.first_picture ? size_in_window : "512";
    reader.take(plan.size, read_size("--size", command.size.value_or(usual)));
    reader.take(plan.repeats, read_repeats(command.repeat, plan.repeats));
    reader.take(plan.budget_s, read_budget(command.budget));
    reader.check(take_light(command.light, plan.light));
    const std::string names = command.tracers.value_or(std::string(usual_tracer().name));
    for (const std::string_view name : split(names, ',')) {
        TraceText text;
        text.tracer = name;
        text.levels = command.levels;
        if (!text.levels)
            text.d_stop = command.d_stop.value_or(command.first_picture ? "14" : "10");
        text.threads = command.threads;
        TraceSettings& settings = plan.settings.emplace_back();
        reader.take(settings, read_trace_settings(text));
        settings.shadows = command.shadows;
        settings.antialias = antialias;
        settings.reflections = plan.light.reflections;
    }
    if (reader.error()) return std::unexpected(*reader.error());
    if (command.suite) {
        reader.take(plan.items, suite_of_file(*command.suite));
    } else {
        plan.items = command.first_picture ? whole_gallery() : gallery_suite();
    }
    return reader.finish(std::move(plan));
}

struct BenchCell {
    FrameTiming timing;
    double compile_ms = 0.0;
    double floor_ms = 0.0;  ///< time by KnownFrame
    double range_per_ray = 0.0, form_per_ray = 0.0, value_per_ray = 0.0;
    CertificateCounts counts;
};

OrInputError<BenchCell> measure(const BenchItem& item, const BenchPlan& plan,
                                const TraceSettings& settings) {
    if (!item.read.rows) return std::unexpected(item.read.rows.error());
    Document document = item.read.document;
    document.light = plan.light;
    const auto prepared = prepare(document, *item.read.rows, Preparation::Compiled);
    if (!prepared) return std::unexpected(prepared.error());
    PictureRequest request = picture_request(prepared->formula, prepared->colors, document,
                                             settings, {plan.size.width, plan.size.height});
    const std::string option = item.name + ", --tracer " + settings.tracer;
    if (const auto refusal = tracer_refusal(settings.tracer, option, request))
        return wrong_input(*refusal);
    add_needed_code(request);
    const Scene scene = scene_of(request);
    Framebuffer frame(plan.size.width, plan.size.height);
    BenchCell cell;
    cell.timing = time_frames(
        scene, request.camera, settings, frame, {.count = plan.repeats, .warm_up = true}, [&] {
            const TimeLimit limit{.until =
                                      until_after(std::chrono::steady_clock::now(), plan.budget_s)};
            return RenderWatch{.limit = limit, .on_tile = {}};
        });
    if (cell.timing.counters.is_cut()) {
        std::cerr << "zeroset: " << item.name << ": the budget of " << short_number(plan.budget_s)
                  << " s is spent; --budget SECONDS gives more\n";
    }
    cell.compile_ms = request.formula->compile_ms;
    const KnownFrame known(scene, request.camera, settings, frame);
    cell.floor_ms = time_repeats(plan.repeats, [&] { known.draw(frame); }).median_ms;
    const auto rays = static_cast<double>(frame.color.size());
    cell.range_per_ray = static_cast<double>(cell.timing.counters.range) / rays;
    cell.form_per_ray = static_cast<double>(cell.timing.counters.form) / rays;
    cell.value_per_ray = static_cast<double>(cell.timing.counters.value) / rays;
    cell.counts = count_certificates(frame);
    return cell;
}

Json json_of(const BenchCell& cell) {
    return {{"frame_ms",
             {{"median", cell.timing.median_ms},
              {"min", cell.timing.min_ms},
              {"max", cell.timing.max_ms},
              {"repeats", cell.timing.repeats}}},
            {"compile_ms", cell.compile_ms},
            {"floor_ms", cell.floor_ms},
            {"times_floor", cell.timing.median_ms / cell.floor_ms},
            {"range_per_ray", cell.range_per_ray},
            {"form_per_ray", cell.form_per_ray},
            {"value_per_ray", cell.value_per_ray},
            {"certified", cell.counts.certified},
            {"undecided", cell.counts.undecided},
            {"miss", cell.counts.miss}};
}

void print_heading(const BenchPlan& plan) {
    std::printf(
        "%dx%d, %d repeats, medians; cells: boxes and beams evaluated per ray; floor: times "
        "what f and its gradient take once for each pixel that is hit\n%-20s",
        plan.size.width, plan.size.height, plan.repeats, "surface");
    for (const TraceSettings& settings : plan.settings) {
        std::printf(" %14s ms      fps  floor    cells compile ms", settings.tracer.c_str());
    }
    std::printf("\n");
}

void print_cell(const BenchCell& cell) {
    std::printf(" %17.3f %8.1f %6.1f %8.2f %10.1f", cell.timing.median_ms,
                1000.0 / cell.timing.median_ms, cell.timing.median_ms / cell.floor_ms,
                cell.range_per_ray + cell.form_per_ray, cell.compile_ms);
}

/// Geometric means over `count` items, from the sums of logarithms, for each tracer.
std::vector<double> means_of(std::vector<double> log_sums, std::size_t count) {
    for (double& sum : log_sums)
        sum = std::exp(sum / static_cast<double>(count));
    return log_sums;
}

void print_means(const std::vector<double>& means, const std::vector<double>& times_floor) {
    std::printf("%-20s", "geometric mean");
    for (std::size_t i = 0; i < means.size(); ++i)
        std::printf(" %17.3f %8.1f %6.1f %19s", means[i], 1000.0 / means[i], times_floor[i], "");
    std::printf("\n");
}

/// Numbers of the plan's tracers, by their names.
Json by_tracer(const BenchPlan& plan, const std::vector<double>& numbers) {
    Json json = Json::object();
    for (std::size_t i = 0; i < numbers.size(); ++i)
        json[plan.settings[i].tracer] = numbers[i];
    return json;
}

}  // namespace

int run_bench(const BenchCommand& command) {
    const auto plan = plan_of(command);
    if (!plan) return report(plan.error());
    if (command.first_picture) {
        return print_first_pictures({.items = plan->items,
                                     .settings = plan->settings.front(),
                                     .size = plan->size,
                                     .repeats = plan->repeats});
    }
    if (command.json && command.json != "-") {
        if (auto writable = check_writable(*command.json); !writable) {
            return report_run_time(writable.error().message);
        }
    }
    const bool table = command.json != "-";
    if (table) print_heading(*plan);
    Json surfaces = Json::array();
    std::vector<double> log_sums(plan->settings.size(), 0.0);
    std::vector<double> log_floors(plan->settings.size(), 0.0);
    for (const BenchItem& item : plan->items) {
        Json row{{"name", item.name}};
        if (table) std::printf("%-20s", item.name.c_str());
        for (std::size_t i = 0; i < plan->settings.size(); ++i) {
            const auto cell = measure(item, *plan, plan->settings[i]);
            if (!cell) return report(cell.error());
            if (table) print_cell(*cell);
            log_sums[i] += std::log(cell->timing.median_ms);
            log_floors[i] += std::log(cell->timing.median_ms / cell->floor_ms);
            row[plan->settings[i].tracer] = json_of(*cell);
        }
        if (table) std::printf("\n");
        std::fflush(stdout);
        surfaces.push_back(std::move(row));
    }
    const std::vector<double> means = means_of(std::move(log_sums), plan->items.size());
    const std::vector<double> floors = means_of(std::move(log_floors), plan->items.size());
    if (table) print_means(means, floors);
    if (!command.json) return exit_ok;
    const int threads = plan->settings.front().threads;
    const std::string text = Json{{"width", plan->size.width},
                                  {"height", plan->size.height},
                                  {"threads", threads > 0 ? threads : core_count()},
                                  {"d_stop", plan->settings.front().stop.value},
                                  {"shadows", command.shadows},
                                  {"antialias", name_of(plan->settings.front().antialias)},
                                  {"look", name_of(plan->light.look)},
                                  {"reflections", plan->light.reflections},
                                  {"geometric_mean_ms", by_tracer(*plan, means)},
                                  {"geometric_mean_times_floor", by_tracer(*plan, floors)},
                                  {"surfaces", surfaces}}
                                 .dump(2) +
                             "\n";
    const auto written = write_text(*command.json, text);
    return written ? exit_ok : report_run_time(written.error().message);
}

}  // namespace zeroset
