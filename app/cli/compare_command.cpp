#include "app/cli/bench_suite.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/compare/printed_tables.hpp"
#include "app/cli/report.hpp"
#include "app/cli/timing.hpp"
#include "engine/base/clock.hpp"
#include "engine/base/text.hpp"
#include "engine/export/file.hpp"
#include "engine/measure/wrong_pixels.hpp"
#include "engine/render/tracers.hpp"
#include "engine/scene/tolerance.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

struct ComparePlan {
    const PrintedTable* table = nullptr;
    std::vector<BenchItem> items;
    std::vector<TraceSettings> settings;  ///< one for each tracer and tolerance
    Size size{};
    int repeats = 3;
    double budget_s = default_budget_s;  ///< for each frame
};

/// The texts between commas.
std::vector<std::string> split_at_commas(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        parts.emplace_back(trimmed(std::string_view(text).substr(begin, end - begin)));
        begin = end + 1;
    }
    return parts;
}

/// A member of the printed values, each value of it once, in their order.
template <class Of>
std::vector<std::string> printed(const PrintedTable& table, const Of& of) {
    std::vector<std::string> all;
    for (const PrintedValue& value : table.values) {
        const std::string text(of(value));
        if (std::ranges::find(all, text) == all.end()) all.push_back(text);
    }
    return all;
}

/// The tracers of the table, behind the usual one, which all are compared with.
std::vector<std::string> usual_tracers(const PrintedTable& table) {
    std::vector<std::string> names{std::string(tracers().front().name)};
    for (std::string& name : printed(table, [](const auto& value) { return value.tracer; }))
        names.push_back(std::move(name));
    return names;
}

OrInputError<const PrintedTable*> table_of(const CompareCommand& command) {
    if (!command.table) return &printed_tables().front();
    if (const PrintedTable* const table = find_printed_table(*command.table)) return table;
    std::string names;
    for (const PrintedTable& table : printed_tables())
        names += " " + std::string(table.name);
    return wrong_input("--table " + *command.table +
                       ": there is no such table; type one of:" + names);
}

OrInputError<std::vector<BenchItem>> items_of(const CompareCommand& command,
                                              const PrintedTable& table) {
    std::vector<BenchItem> suite = gallery_suite();
    if (command.surfaces == "all") return suite;
    const std::vector<std::string> names =
        command.surfaces ? split_at_commas(*command.surfaces)
                         : printed(table, [](const auto& value) { return value.surface; });
    std::vector<BenchItem> items;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(suite, name, &BenchItem::name);
        if (found == suite.end()) {
            std::string all;
            for (const BenchItem& item : suite)
                all += " " + item.name;
            return wrong_input("--surface " + name +
                               ": there is no such surface; type all, or some of:" + all);
        }
        items.push_back(*found);
    }
    return items;
}

OrInputError<std::vector<TraceSettings>> settings_of(const CompareCommand& command,
                                                     const PrintedTable& table) {
    std::vector<std::string> names = usual_tracers(table);
    if (command.tracers == "all") {
        names.clear();
        for (const Tracer& tracer : tracers())
            names.emplace_back(tracer.name);
    } else if (command.tracers) {
        names = split_at_commas(*command.tracers);
    }
    const std::vector<std::string> depths =
        command.d_stop
            ? split_at_commas(*command.d_stop)
            : printed(table, [](const auto& value) { return std::to_string(value.d_stop); });
    std::vector<TraceSettings> all;
    for (const std::string& depth : depths) {
        for (const std::string& name : names) {
            TraceText text;
            text.tracer = name;
            text.d_stop = depth;
            text.threads = command.threads.value_or("1");
            auto settings = read_trace_settings(text);
            if (!settings) return std::unexpected(settings.error());
            all.push_back(std::move(*settings));
        }
    }
    return all;
}

OrInputError<ComparePlan> plan_of(const CompareCommand& command) {
    ComparePlan plan;
    const auto table = table_of(command);
    if (!table) return std::unexpected(table.error());
    plan.table = *table;
    auto items = items_of(command, *plan.table);
    if (!items) return std::unexpected(items.error());
    plan.items = std::move(*items);
    auto settings = settings_of(command, *plan.table);
    if (!settings) return std::unexpected(settings.error());
    plan.settings = std::move(*settings);
    const auto size =
        read_size("--size", command.size.value_or(std::to_string(plan.table->size_px)));
    if (!size) return std::unexpected(size.error());
    plan.size = *size;
    const auto repeats = read_repeats(command.repeat, plan.repeats);
    if (!repeats) return std::unexpected(repeats.error());
    plan.repeats = *repeats;
    const auto budget = read_budget(command.budget);
    if (!budget) return std::unexpected(budget.error());
    plan.budget_s = *budget;
    return plan;
}

/// A row of the table: a surface by a tracer at a tolerance.
struct Row {
    std::string surface, tracer;
    int d_stop = 0;
    FrameTiming timing;
    double cells_per_ray = 0.0;   ///< boxes and cells that were evaluated
    double values_per_ray = 0.0;  ///< points
    CertificateCounts counts;
    WrongPixels wrong;
    std::size_t certified_there = 0;  ///< pixels that are certified in the finest picture by beams
    std::optional<double> printed_ms;
    /// Times over those of the surface's first tracer of the paper at this tolerance.
    std::optional<double> times, printed_times;
};

/// A surface, ready to be drawn.
class Subject {
public:
    static OrInputError<Subject> make(const BenchItem& item, const ComparePlan& plan) {
        if (!item.read.rows) return std::unexpected(item.read.rows.error());
        Document document = item.read.document;
        document.light = {};
        const auto prepared = prepare(document, *item.read.rows, Preparation::Compiled);
        if (!prepared) return std::unexpected(prepared.error());
        PictureRequest request = picture_request(prepared->formula, prepared->colors, document, {},
                                                 {plan.size.width, plan.size.height});
        add_needed_code(request);
        Subject subject(item.name, request);
        const FrameTiming timing = subject.draw(finest(), 1, false, 100.0, subject.proved_);
        if (timing.counters.is_cut())
            return wrong_input("--surface " + item.name +
                               ": it takes too long to prove; leave it "
                               "out, or choose a smaller --size");
        return subject;
    }

    Row measured(const TraceSettings& settings, const ComparePlan& plan) {
        Row row;
        row.surface = name_;
        row.tracer = settings.tracer;
        row.d_stop = static_cast<int>(settings.stop.value);
        Framebuffer frame(plan.size.width, plan.size.height);
        row.timing = draw(settings, plan.repeats, true, plan.budget_s, frame);
        const auto rays = static_cast<double>(frame.color.size());
        const Counters& counters = row.timing.counters;
        row.cells_per_ray = static_cast<double>(counters.range + counters.form) / rays;
        row.values_per_ray = static_cast<double>(counters.value) / rays;
        row.counts = count_certificates(frame);
        const double cell = std::ldexp(scene_.clip.size(), -row.d_stop);
        const auto precision = wanted_precision(scene_, ViewFrame(camera_), settings.stop);
        const auto width = certified_width(scene_.clip, settings.stop, precision);
        row.wrong = wrong_pixels(frame, proved_, camera_, width.value_or(4.0 * cell));
        row.certified_there = count_certificates(proved_).certified;
        row.printed_ms = plan.table->printed_ms(row.surface, row.tracer, row.d_stop);
        return row;
    }

private:
    Subject(std::string name, const PictureRequest& request)
        : name_(std::move(name)),
          scene_(scene_of(request)),
          camera_(request.camera),
          proved_(request.size_px.x, request.size_px.y) {}

    static TraceSettings finest() {
        TraceSettings settings;
        settings.threads = 0;
        return settings;
    }
    FrameTiming draw(const TraceSettings& settings, int repeats, bool warm_up, double budget_s,
                     Framebuffer& frame) const {
        return time_frames(
            scene_, camera_, settings, frame, {.count = repeats, .warm_up = warm_up}, [&] {
                const auto now = std::chrono::steady_clock::now();
                return RenderWatch{.limit = {.until = until_after(now, budget_s)}, .on_tile = {}};
            });
    }

    std::string name_;
    Scene scene_;
    Camera camera_;
    Framebuffer proved_;  ///< by beams, as fine as there is
};

/// Fills in the times over those of the first tracer with a printed value.
void set_times(std::vector<Row>& rows) {
    for (Row& row : rows) {
        const auto base = std::ranges::find_if(rows, [&](const Row& other) {
            return other.surface == row.surface && other.d_stop == row.d_stop && other.printed_ms;
        });
        if (base == rows.end()) continue;
        row.times = row.timing.median_ms / base->timing.median_ms;
        if (row.printed_ms) row.printed_times = *row.printed_ms / *base->printed_ms;
    }
}

void print_heading(const ComparePlan& plan) {
    const PrintedTable& table = *plan.table;
    const int threads = plan.settings.front().threads;
    std::printf("%s (%s): %s.\n", std::string(table.source).c_str(),
                std::string(table.machine).c_str(), std::string(table.note).c_str());
    std::printf(
        "Here %dx%d, %d thread(s), medians of %d; cells, values: boxes and beams, points "
        "a ray; missed, added, moved:\npixels unlike those proved by beams at d_stop %d; x: "
        "times the paper's first tracer, here and as printed.\n\n",
        plan.size.width, plan.size.height, threads, plan.repeats, max_d_stop);
    std::printf("%-19s %6s %-15s %10s %8s %8s %7s %7s %7s %9s %7s %11s %9s\n", "surface", "d_stop",
                "tracer", "ms", "cells", "values", "missed", "added", "moved", "undecided", "x",
                "printed ms", "printed x");
}

std::string optional_text(const char* format, const std::optional<double>& value) {
    if (!value) return "-";
    char text[40];
    std::snprintf(text, sizeof text, format, *value);
    return text;
}

void print_row(const Row& row) {
    std::printf("%-19s %6d %-15s %10.2f %8.2f %8.2f %7zu %7zu %7zu %9zu %7s %11s %9s%s\n",
                row.surface.c_str(), row.d_stop, row.tracer.c_str(), row.timing.median_ms,
                row.cells_per_ray, row.values_per_ray, row.wrong.missed, row.wrong.added,
                row.wrong.moved, row.counts.undecided, optional_text("%.2f", row.times).c_str(),
                optional_text("%.0f", row.printed_ms).c_str(),
                optional_text("%.2f", row.printed_times).c_str(),
                row.timing.counters.is_cut() ? "  (cut by --budget)" : "");
    std::fflush(stdout);
}

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json json_of(const Row& row) {
    return {{"surface", row.surface},
            {"d_stop", row.d_stop},
            {"tracer", row.tracer},
            {"frame_ms",
             {{"median", row.timing.median_ms},
              {"min", row.timing.min_ms},
              {"max", row.timing.max_ms},
              {"repeats", row.timing.repeats}}},
            {"cut", row.timing.counters.is_cut()},
            {"cells_per_ray", row.cells_per_ray},
            {"values_per_ray", row.values_per_ray},
            {"certified", row.counts.certified},
            {"undecided", row.counts.undecided},
            {"miss", row.counts.miss},
            {"certified_by_beams", row.certified_there},
            {"missed", row.wrong.missed},
            {"added", row.wrong.added},
            {"moved", row.wrong.moved},
            {"refuted", row.wrong.refuted},
            {"times", json_of(row.times)},
            {"printed_ms", json_of(row.printed_ms)},
            {"printed_times", json_of(row.printed_times)}};
}

struct MeanKey {
    int d_stop;
    std::string tracer;
    auto operator<=>(const MeanKey&) const = default;
};

/// Geometric means of the frames' times over all surfaces.
std::map<MeanKey, double> means_of(const std::vector<Row>& rows) {
    std::map<MeanKey, std::pair<double, int>> sums;
    for (const Row& row : rows) {
        auto& [sum, count] = sums[{.d_stop = row.d_stop, .tracer = row.tracer}];
        sum += std::log(row.timing.median_ms);
        ++count;
    }
    std::map<MeanKey, double> means;
    for (const auto& [key, sum] : sums)
        means[key] = std::exp(sum.first / sum.second);
    return means;
}

Json json_of(const ComparePlan& plan, const std::vector<Row>& rows) {
    Json json_rows = Json::array();
    for (const Row& row : rows)
        json_rows.push_back(json_of(row));
    Json means = Json::array();
    for (const auto& [key, ms] : means_of(rows))
        means.push_back({{"d_stop", key.d_stop}, {"tracer", key.tracer}, {"ms", ms}});
    return {{"table", plan.table->name},
            {"source", plan.table->source},
            {"machine_printed", plan.table->machine},
            {"note", plan.table->note},
            {"width", plan.size.width},
            {"height", plan.size.height},
            {"threads", plan.settings.front().threads},
            {"geometric_means", means},
            {"rows", json_rows}};
}

}  // namespace

int run_compare(const CompareCommand& command) {
    const auto plan = plan_of(command);
    if (!plan) return report(plan.error());
    const bool has_file = command.json && command.json != "-";
    if (has_file) {
        if (auto writable = check_writable(*command.json); !writable)
            return report_run_time(writable.error().message);
    }
    const bool prints = command.json != "-";
    if (prints) print_heading(*plan);
    std::vector<Row> rows;
    for (const BenchItem& item : plan->items) {
        auto subject = Subject::make(item, *plan);
        if (!subject) return report(subject.error());
        std::vector<Row> of_surface;
        for (const TraceSettings& settings : plan->settings)
            of_surface.push_back(subject->measured(settings, *plan));
        set_times(of_surface);
        if (prints) std::ranges::for_each(of_surface, print_row);
        std::ranges::move(of_surface, std::back_inserter(rows));
    }
    if (prints && plan->items.size() > 1) {
        for (const auto& [key, ms] : means_of(rows))
            std::printf("%-19s %6d %-15s %10.2f\n", "geometric mean", key.d_stop,
                        key.tracer.c_str(), ms);
    }
    if (!command.json) return exit_ok;
    const auto written = write_text(*command.json, json_of(*plan, rows).dump(2) + "\n");
    return written ? exit_ok : report_run_time(written.error().message);
}

}  // namespace zeroset
