#include "app/cli/bench_suite.hpp"
#include "app/cli/report.hpp"
#include "engine/base/text.hpp"
#include "engine/export/file.hpp"
#include "engine/render/tracers.hpp"
#include "papers/commands/compare_animation.hpp"
#include "papers/commands/compare_shadows.hpp"
#include "papers/commands/compare_subject.hpp"
#include "papers/commands/compare_voxels.hpp"
#include "papers/commands/paper_commands.hpp"
#include "papers/compare/animations.hpp"
#include "papers/compare/compared_row.hpp"
#include "papers/compare/plot.hpp"
#include "papers/compare/printed_tables.hpp"
#include "papers/compare/shadow_scenes.hpp"
#include "papers/compare/voxel_tables.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// A way to draw each surface.
struct Measurement {
    int wanted_d_stop;
    TraceSettings settings;
};

struct ComparePlan {
    CompareFrames frames;
    std::vector<BenchItem> items;
    std::vector<Measurement> measurements;
    bool all_tracers = false;  ///< those that draw a surface
    std::optional<PlotFormat> plot;
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
    std::vector<std::string> names{std::string(usual_tracer().name)};
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
    for (const PrintedAnimation& animation : printed_animations())
        names += " " + std::string(animation.name);
    names += " " + std::string(shadow_table().name);
    for (const VoxelTable& voxels : voxel_tables())
        names += " " + std::string(voxels.name);
    return wrong_input(*command.table + ": there is no such table; type one of:" + names);
}

/// The gallery's surfaces from papers, and those of the table alone.
std::vector<BenchItem> suite_of(const PrintedTable& table) {
    std::vector<BenchItem> suite = gallery_suite();
    for (const PrintedSurface& surface : table.surfaces) {
        BenchItem& added = suite.emplace_back(std::string(surface.name),
                                              read_document_text(std::string(surface.formula)));
        added.read.document.clip = Box::cube(surface.domain);
        added.read.document.camera = suite_camera(surface.domain);
    }
    return suite;
}

OrInputError<std::vector<BenchItem>> items_of(const CompareCommand& command,
                                              const PrintedTable& table) {
    std::vector<BenchItem> suite = suite_of(table);
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

std::vector<std::string> tracers_of(const CompareCommand& command, const PrintedTable& table) {
    if (!command.tracers) return usual_tracers(table);
    if (*command.tracers != "all") return split_at_commas(*command.tracers);
    std::vector<std::string> names;
    for (const Tracer& tracer : tracers())
        names.emplace_back(tracer.name);
    return names;
}

/// The tracer at a tolerance of the table or of the command.
OrInputError<Measurement> measurement(const std::string& tracer, const std::string& d_stop,
                                      const CompareCommand& command) {
    TraceText text;
    text.tracer = tracer;
    text.threads = command.threads.value_or("1");
    const int wanted = std::atoi(d_stop.c_str());
    if (command.d_stop || wanted <= max_d_stop) {
        text.d_stop = d_stop;
    } else if (const Tracer* const found = find_tracer(tracer); found && found->takes_levels) {
        text.levels = d_stop;
    }
    auto settings = read_trace_settings(text);
    if (!settings) return std::unexpected(settings.error());
    return Measurement{.wanted_d_stop = wanted, .settings = std::move(*settings)};
}

OrInputError<std::vector<Measurement>> measurements_of(const CompareCommand& command,
                                                       const PrintedTable& table) {
    const std::vector<std::string> depths =
        command.d_stop
            ? split_at_commas(*command.d_stop)
            : printed(table, [](const auto& value) { return std::to_string(value.d_stop); });
    const std::vector<std::string> reflections =
        printed(table, [](const auto& value) { return std::to_string(value.reflections); });
    std::vector<Measurement> all;
    for (const std::string& depth : depths) {
        for (const std::string& mirrors : reflections) {
            for (const std::string& name : tracers_of(command, table)) {
                auto made = measurement(name, depth, command);
                if (!made) return std::unexpected(made.error());
                made->settings.reflections = std::atoi(mirrors.c_str());
                all.push_back(std::move(*made));
            }
        }
    }
    return all;
}

OrInputError<ComparePlan> plan_of(const CompareCommand& command) {
    ComparePlan plan;
    const auto table = table_of(command);
    if (!table) return std::unexpected(table.error());
    auto items = items_of(command, **table);
    if (!items) return std::unexpected(items.error());
    plan.items = std::move(*items);
    auto measurements = measurements_of(command, **table);
    if (!measurements) return std::unexpected(measurements.error());
    plan.measurements = std::move(*measurements);
    plan.all_tracers = command.tracers == "all";
    const auto frames = read_frames(command, std::to_string((*table)->size_px));
    if (!frames) return std::unexpected(frames.error());
    plan.frames = *frames;
    plan.frames.table = *table;
    const auto plot = read_plot(command);
    if (!plot) return std::unexpected(plot.error());
    plan.plot = *plot;
    return plan;
}

OrInputError<std::vector<ComparedRow>> measure_all(const ComparePlan& plan, bool prints) {
    std::vector<ComparedRow> rows;
    for (const BenchItem& item : plan.items) {
        auto subject = CompareSubject::make(item, plan.frames);
        if (!subject) return std::unexpected(subject.error());
        std::vector<ComparedRow> of_surface;
        of_surface.reserve(plan.measurements.size());
        for (const Measurement& how : plan.measurements) {
            if (const auto refusal = subject->refusal(how.settings)) {
                if (plan.all_tracers) continue;
                return wrong_input(*refusal);
            }
            of_surface.push_back(subject->measured(how.wanted_d_stop, how.settings, plan.frames));
        }
        set_times(of_surface);
        for (const ComparedRow& row : of_surface) {
            if (prints) print(row_text(row));
        }
        std::ranges::move(of_surface, std::back_inserter(rows));
    }
    return rows;
}

/// The first file that cannot be written, as a message.
std::optional<std::string> unwritable(const CompareCommand& command) {
    for (const auto* const file : {&command.json, &command.plot}) {
        if (!*file || **file == "-") continue;
        if (auto writable = check_writable(**file); !writable) return writable.error().message;
    }
    return std::nullopt;
}

}  // namespace

int run_compare(const CompareCommand& command) {
    if (command.table) {
        if (const PrintedAnimation* const animation = find_printed_animation(*command.table))
            return run_compare_animation(command, *animation);
        if (*command.table == shadow_table().name) return run_compare_shadows(command);
    }
    if (command.table) {
        if (const VoxelTable* const table = find_voxel_table(*command.table))
            return run_compare_voxels(command, *table);
    }
    const auto plan = plan_of(command);
    if (!plan) return report(plan.error());
    if (const auto message = unwritable(command)) return report_run_time(*message);
    const bool prints = command.json != "-";
    const Comparison comparison{.table = plan->frames.table,
                                .width = plan->frames.size.width,
                                .height = plan->frames.size.height,
                                .threads = plan->measurements.front().settings.threads,
                                .repeats = plan->frames.repeats};
    if (prints) print(heading_text(comparison));
    const auto rows = measure_all(*plan, prints);
    if (!rows) return report(rows.error());
    if (prints) {
        if (plan->items.size() > 1) print(means_text(*rows));
        print(boxes_text(comparison, *rows));
    }
    if (command.json) {
        const auto written = write_text(*command.json, comparison_json(comparison, *rows));
        if (!written) return report_run_time(written.error().message);
    }
    if (!command.plot) return exit_ok;
    const auto drawn = write_plot(*command.plot, *plan->plot, comparison, *rows);
    return drawn ? exit_ok : report_run_time(drawn.error());
}

}  // namespace zeroset
