#include "papers/commands/compare_shadows.hpp"

#include "app/cli/report.hpp"
#include "engine/base/clock.hpp"
#include "engine/export/file.hpp"
#include "engine/light/shade.hpp"
#include "engine/light/shadow.hpp"
#include "engine/real/rounding.hpp"
#include "engine/render/tracers.hpp"
#include "engine/trace/hit_gradients.hpp"
#include "engine/trace/tile_grid.hpp"
#include "papers/commands/compare_scene.hpp"
#include "papers/compare/shadow_scenes.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<ShadowWay, const char*>, 3> ways{
    {{ShadowWay::Beams, "beams"}, {ShadowWay::Boxes, "boxes"}, {ShadowWay::Rays, "rays"}}};

std::uint64_t count(const TileBits& bits) {
    std::uint64_t sum = 0;
    for (const std::uint64_t row : bits)
        sum += static_cast<std::uint64_t>(std::popcount(row));
    return sum;
}

/// Pixels of a tile in which two ways differ; in `of_proved` of those that both have proved.
std::uint64_t differences(const ShadowBits& a, const ShadowBits& b, bool of_proved) {
    TileBits differ{};
    for (std::size_t row = 0; row < differ.size(); ++row) {
        differ[row] = a.dark[row] ^ b.dark[row];
        if (of_proved) differ[row] &= ~(a.unproved[row] | b.unproved[row]);
    }
    return count(differ);
}

/// The figures of one way to find the shadows of a picture.
struct ShadowRow {
    std::string scene, way;
    double ms = 0.0;  ///< the median
    std::uint64_t hits = 0, dark = 0, unproved = 0, single_rays = 0;
    double cells_per_hit = 0.0;
    std::uint64_t differing = 0, refuted = 0;  ///< pixels, against the first way
    double times = 1.0;                        ///< the time over that of single rays
};

/// A surface as beams see it, tile by tile, ready for questions about its shadows.
class ShadowedPicture {
public:
    ShadowedPicture(const ComparedScene& compared, const ComparedSettings& settings)
        : scene_(compared.scene),
          view_(compared.camera),
          frame_(trace_frame(scene_, scene_.surfaces.front(), view_,
                             {.width = settings.size_px, .height = settings.size_px},
                             settings.settings.stop)),
          grid_(settings.size_px, settings.size_px),
          hits_(grid_.size()),
          first_(grid_.size()) {
        const UpwardRegisters upward;
        Counters counters;
        for (std::size_t i = 0; i < grid_.size(); ++i) {
            usual_tracer().trace_tile(frame_, grid_.tile(i), hits_[i], counters);
            find_gradients(frame_, grid_.tile(i), hits_[i], counters);
        }
    }

    ShadowRow measured(const std::string& scene, ShadowWay way, const char* name) {
        constexpr int repeats = 3;
        ShadowRow row;
        std::array<double, repeats> times{};
        for (double& ms : times)
            ms = find(way, row);
        std::ranges::sort(times);
        row.ms = times[repeats / 2];
        row.scene = scene;
        row.way = name;
        return row;
    }

private:
    /// Finds the shadows of all tiles; the time.
    double find(ShadowWay way, ShadowRow& row) {
        const UpwardRegisters upward;
        row = {};
        double ms = 0.0;
        Counters counters;
        for (std::size_t i = 0; i < grid_.size(); ++i) {
            LitTile lit;
            lit.begin(std::span(hits_).subspan(i, 1));
            const auto start = std::chrono::steady_clock::now();
            const ShadowBits found = find_shadows(std::span(&frame_, 1), key_light(view_), {},
                                                  grid_.tile(i), lit.layers(), counters, way);
            ms += ms_since(start);
            if (way == ways.front().first) first_[i] = found;
            row.hits += static_cast<std::uint64_t>(
                std::ranges::count_if(hits_[i].depth, [](float t) { return std::isfinite(t); }));
            row.dark += count(found.dark);
            row.unproved += count(found.unproved);
            row.single_rays += found.single_rays;
            row.differing += differences(found, first_[i], false);
            row.refuted += differences(found, first_[i], true);
        }
        if (row.hits > 0)
            row.cells_per_hit = static_cast<double>(counters.form) / static_cast<double>(row.hits);
        return ms;
    }

    Scene scene_;
    ViewFrame view_;
    TraceFrame frame_;
    TileGrid grid_;
    std::vector<TileHits> hits_;     ///< of each tile
    std::vector<ShadowBits> first_;  ///< by the first way
};

void print_heading(const ComparedSettings& settings) {
    const ShadowTable& table = shadow_table();
    std::printf(
        "%s; %s.\nPrinted: %.0f minutes by single rays, %.0f with boxes.\nHere %dx%d, 1 thread, "
        "medians of 3: shadows alone, of what beams show. Boxes of 8 x 8 hits are rejected by "
        "beams, else single rays;\nx: times single rays; refuted: pixels of which two ways have "
        "proved unlike things.\n\n",
        std::string(table.source).c_str(), std::string(table.note).c_str(), table.printed_rays_min,
        table.printed_boxes_min, settings.size_px, settings.size_px);
    std::printf("%-12s %-6s %9s %7s %8s %8s %9s %12s %10s %10s %8s\n", "surface", "way", "ms", "x",
                "hits", "dark", "unproved", "single rays", "cells/hit", "differing", "refuted");
}

void print_row(const ShadowRow& row) {
    std::printf(
        "%-12s %-6s %9.2f %7.2f %8llu %8llu %9llu %12llu %10.2f %10llu %8llu\n", row.scene.c_str(),
        row.way.c_str(), row.ms, row.times, static_cast<unsigned long long>(row.hits),
        static_cast<unsigned long long>(row.dark), static_cast<unsigned long long>(row.unproved),
        static_cast<unsigned long long>(row.single_rays), row.cells_per_hit,
        static_cast<unsigned long long>(row.differing),
        static_cast<unsigned long long>(row.refuted));
    std::fflush(stdout);
}

Json json_of(const std::vector<ShadowRow>& rows) {
    Json json_rows = Json::array();
    for (const ShadowRow& row : rows)
        json_rows.push_back({{"surface", row.scene},
                             {"way", row.way},
                             {"ms", row.ms},
                             {"times", row.times},
                             {"hits", row.hits},
                             {"dark", row.dark},
                             {"unproved", row.unproved},
                             {"single_rays", row.single_rays},
                             {"cells_per_hit", row.cells_per_hit},
                             {"differing", row.differing},
                             {"refuted", row.refuted}});
    const ShadowTable& table = shadow_table();
    return {
        {"table", table.name},
        {"source", table.source},
        {"note", table.note},
        {"printed_minutes", {{"rays", table.printed_rays_min}, {"boxes", table.printed_boxes_min}}},
        {"rows", json_rows}};
}

/// The rows of a scene, one for each way.
std::vector<ShadowRow> rows_of(const ShadowScene& scene, const ComparedScene& compared,
                               const ComparedSettings& settings) {
    ShadowedPicture picture(compared, settings);
    std::vector<ShadowRow> rows;
    rows.reserve(ways.size());
    for (const auto& [way, name] : ways)
        rows.push_back(picture.measured(std::string(scene.name), way, name));
    for (ShadowRow& row : rows)
        row.times = row.ms / rows.back().ms;
    return rows;
}

}  // namespace

int run_compare_shadows(const CompareCommand& command) {
    const ShadowTable& table = shadow_table();
    const std::string name(table.name);
    if (command.threads && *command.threads != "1")
        return report({.reason = "--threads: " + name + " runs on one; leave the option out"});
    const auto settings =
        read_compared_settings(command, name + " is of shadows", "16", table.size_px);
    if (!settings) return report(settings.error());
    const bool prints = command.json != "-";
    if (command.json && prints) {
        if (auto writable = check_writable(*command.json); !writable)
            return report_run_time(writable.error().message);
    }
    if (prints) print_heading(*settings);
    std::vector<ShadowRow> rows;
    for (const ShadowScene& scene : table.scenes) {
        const auto compared = compared_scene(scene.formula, scene.domain, *settings);
        if (!compared) return report(compared.error());
        for (ShadowRow& row : rows_of(scene, *compared, *settings)) {
            if (prints) print_row(row);
            rows.push_back(std::move(row));
        }
    }
    if (!command.json) return exit_ok;
    const auto written = write_text(*command.json, json_of(rows).dump(2) + "\n");
    return written ? exit_ok : report_run_time(written.error().message);
}

}  // namespace zeroset
