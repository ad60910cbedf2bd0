#include "app/cli/report.hpp"
#include "app/dev/bench_suite.hpp"
#include "engine/base/text.hpp"
#include "engine/render/tracers.hpp"
#include "papers/commands/compare_animation.hpp"
#include "papers/commands/compare_output.hpp"
#include "papers/commands/compare_scene.hpp"
#include "papers/commands/compare_shadows.hpp"
#include "papers/commands/compare_subject.hpp"
#include "papers/commands/compare_voxels.hpp"
#include "papers/commands/paper_commands.hpp"
#include "papers/compare/compared_row.hpp"
#include "papers/compare/printed_tables.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <span>
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

/// A member of the table's columns or rows, each value of it once, in their order.
template <class Item, class Member>
std::vector<Member> distinct(const std::vector<Item>& items, Member Item::* member) {
    std::vector<Member> all;
    for (const Item& item : items) {
        if (std::ranges::find(all, item.*member) == all.end()) all.push_back(item.*member);
    }
    return all;
}

OrInputError<const PrintedTable*> table_of(const CompareCommand& command) {
    const PrintedTables& all = printed_tables();
    if (!command.table) return &all.tables.front();
    if (const PrintedTable* const table = find_named(all.tables, *command.table)) return table;
    std::string names;
    const auto add_names = [&](const auto& items) {
        for (const auto& item : items)
            names += " " + item.name;
    };
    add_names(all.tables);
    add_names(all.animations);
    add_names(std::span(&all.shadows, 1));
    add_names(all.voxel_tables);
    return wrong_input(*command.table + ": there is no such table; type one of:" + names);
}

/// The gallery's surfaces from papers, and those of the table alone.
std::vector<BenchItem> suite_of(const PrintedTable& table) {
    std::vector<BenchItem> suite = gallery_suite();
    for (const PrintedScene& scene : table.scenes)
        suite.push_back(item_of(scene));
    return suite;
}

OrInputError<std::vector<BenchItem>> items_of(const CompareCommand& command,
                                              const PrintedTable& table) {
    std::vector<BenchItem> suite = suite_of(table);
    if (command.surfaces == "all") return suite;
    const std::vector<std::string> names = command.surfaces
                                               ? split_at_commas(*command.surfaces)
                                               : distinct(table.rows, &PrintedRow::surface);
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

/// The usual one, which all are compared with, comes before those of the table.
std::vector<std::string> tracers_of(const CompareCommand& command, const PrintedTable& table) {
    if (command.tracers && *command.tracers != "all") return split_at_commas(*command.tracers);
    std::vector<std::string> names;
    if (command.tracers) {
        for (const Tracer& tracer : tracers())
            names.emplace_back(tracer.name);
    } else {
        names = distinct(table.columns, &PrintedColumn::tracer);
        names.insert(names.begin(), std::string(usual_tracer().name));
    }
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
    } else if (const Tracer* const found = find_tracer(tracer); found && found->needs.levels > 0) {
        text.levels = d_stop;
    }
    auto settings = read_trace_settings(text);
    if (!settings) return std::unexpected(settings.error());
    return Measurement{.wanted_d_stop = wanted, .settings = std::move(*settings)};
}

OrInputError<std::vector<Measurement>> measurements_of(const CompareCommand& command,
                                                       const PrintedTable& table) {
    std::vector<std::string> depths;
    if (command.d_stop) {
        depths = split_at_commas(*command.d_stop);
    } else {
        for (const int d_stop : distinct(table.columns, &PrintedColumn::d_stop))
            depths.push_back(std::to_string(d_stop));
    }
    std::vector<Measurement> all;
    for (const std::string& depth : depths) {
        for (const int reflections : distinct(table.columns, &PrintedColumn::reflections)) {
            for (const std::string& name : tracers_of(command, table)) {
                auto made = measurement(name, depth, command);
                if (!made) return std::unexpected(made.error());
                made->settings.reflections = reflections;
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
    return plan;
}

OrInputError<std::vector<ComparedRow>> measure_all(const ComparePlan& plan,
                                                   const CompareOutput& output) {
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
        for (const ComparedRow& row : of_surface)
            output.print(row_text(row));
        std::ranges::move(of_surface, std::back_inserter(rows));
    }
    return rows;
}

/// Compares with a table of times of frames.
int run_compare_frames(const CompareCommand& command) {
    const auto plan = plan_of(command);
    if (!plan) return report(plan.error());
    const CompareOutput output(command.json);
    if (const auto message = output.unwritable()) return report_run_time(*message);
    const Comparison comparison{.table = plan->frames.table,
                                .width = plan->frames.size.width,
                                .height = plan->frames.size.height,
                                .threads = plan->measurements.front().settings.threads,
                                .repeats = plan->frames.repeats};
    output.print(heading_text(comparison));
    const auto rows = measure_all(*plan, output);
    if (!rows) return report(rows.error());
    return output.finish(json_of(comparison, *rows));
}

}  // namespace

int run_compare(const CompareCommand& command) {
    const PrintedTables& all = printed_tables();
    const std::string table = command.table.value_or("");
    if (const auto* const animation = find_named(all.animations, table))
        return run_compare_animation(command, *animation);
    if (const auto* const voxels = find_named(all.voxel_tables, table))
        return run_compare_voxels(command, *voxels);
    if (table == all.shadows.name) return run_compare_shadows(command);
    return run_compare_frames(command);
}

}  // namespace zeroset
