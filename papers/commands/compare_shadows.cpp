#include "papers/commands/compare_shadows.hpp"

#include "app/cli/report.hpp"
#include "engine/base/clock.hpp"
#include "engine/light/shade.hpp"
#include "engine/light/shadow.hpp"
#include "engine/real/rounding.hpp"
#include "engine/render/tracers.hpp"
#include "engine/trace/hit_gradients.hpp"
#include "engine/trace/tile_grid.hpp"
#include "papers/commands/compare_output.hpp"
#include "papers/commands/compare_scene.hpp"
#include "papers/compare/printed_tables.hpp"
#include "papers/compare/text_columns.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

/// The centres of a tile's pixels as places of its own, with which shadows are found by single
/// rays.
struct CentrePlaces {
    std::array<float, tile_pixels> col{}, row{};

    CentrePlaces() {
        for (std::size_t at = 0; at < tile_pixels; ++at) {
            col[at] = static_cast<float>(at % tile_size);
            row[at] = static_cast<float>(at / tile_size);
        }
    }
};

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
    double ms = 0.0;  ///< the median
    std::uint64_t hits = 0, dark = 0, unproved = 0;
    double cells_per_hit = 0.0;
    std::uint64_t differing = 0, refuted = 0;  ///< pixels, against beams
};

/// A surface as beams see it, tile by tile, ready for questions about its shadows.
class ShadowedPicture {
public:
    explicit ShadowedPicture(const PictureRequest& request)
        : scene_(scene_of(request)),
          view_(request.camera),
          frame_(trace_frame(scene_, scene_.surfaces.front(), view_,
                             {.width = request.size_px.x, .height = request.size_px.y},
                             request.settings.stop)),
          grid_(request.size_px.x, request.size_px.y),
          hits_(grid_.size()),
          first_(grid_.size()) {
        const UpwardRegisters upward;
        Counters counters;
        for (std::size_t i = 0; i < grid_.size(); ++i) {
            usual_tracer().trace_tile(frame_, grid_.tile(i), hits_[i], counters);
            find_gradients(frame_, grid_.tile(i), hits_[i], counters);
        }
    }

    /// By beams, and then by single rays.
    ShadowRow measured(bool singly) {
        constexpr int repeats = 3;
        ShadowRow row;
        std::array<double, repeats> times{};
        for (double& ms : times)
            ms = find(singly, row);
        std::ranges::sort(times);
        row.ms = times[repeats / 2];
        return row;
    }

private:
    /// Finds the shadows of all tiles; the time.
    double find(bool singly, ShadowRow& row) {
        const UpwardRegisters upward;
        const RayPlaces places{.col = centres_.col.data(), .row = centres_.row.data()};
        row = {};
        double ms = 0.0;
        Counters counters;
        for (std::size_t i = 0; i < grid_.size(); ++i) {
            LitTile lit;
            lit.begin(std::span(hits_).subspan(i, 1));
            Tile tile = grid_.tile(i);
            if (singly) tile.places = &places;
            const auto start = std::chrono::steady_clock::now();
            const ShadowBits found = find_shadows(std::span(&frame_, 1), key_light(view_), {}, tile,
                                                  lit.layers(), counters);
            ms += ms_since(start);
            if (!singly) first_[i] = found;
            row.hits += static_cast<std::uint64_t>(
                std::ranges::count_if(hits_[i].depth, [](float t) { return std::isfinite(t); }));
            row.dark += count(found.dark);
            row.unproved += count(found.unproved);
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
    std::vector<ShadowBits> first_;  ///< by beams
    CentrePlaces centres_;
};

const std::array<TextColumn, 10>& shadow_columns() {
    static const std::array<TextColumn, 10> all{{{"surface", "/surface", -12},
                                                 {"way", "/way", -6},
                                                 {"ms", "/ms", 9, 2},
                                                 {"x", "/times", 7, 2},
                                                 {"hits", "/hits", 8},
                                                 {"dark", "/dark", 8},
                                                 {"unproved", "/unproved", 9},
                                                 {"cells/hit", "/cells_per_hit", 10, 2},
                                                 {"differing", "/differing", 10},
                                                 {"refuted", "/refuted", 8}}};
    return all;
}

std::string heading_text(const ShadowTable& table, int size_px) {
    return table.source + "; " + table.note +
           formatted(
               ".\nPrinted: %.0f minutes by single rays, %.0f with boxes.\nHere %dx%d, 1 thread, "
               "medians of 3: shadows alone, of what beams show; x: times single rays; refuted: "
               "pixels of which\nthe two ways have proved unlike things.\n\n",
               table.printed_rays_min, table.printed_boxes_min, size_px, size_px) +
           title_line(shadow_columns());
}

/// The rows of a scene: by beams, by single rays.
std::array<Json, 2> rows_of(const PrintedScene& scene, const PictureRequest& request) {
    ShadowedPicture picture(request);
    const std::array rows{picture.measured(false), picture.measured(true)};
    const auto json_of = [&](const char* way, const ShadowRow& row) -> Json {
        return {{"surface", scene.name},
                {"way", way},
                {"ms", row.ms},
                {"times", row.ms / rows[1].ms},
                {"hits", row.hits},
                {"dark", row.dark},
                {"unproved", row.unproved},
                {"cells_per_hit", row.cells_per_hit},
                {"differing", row.differing},
                {"refuted", row.refuted}};
    };
    return {json_of("beams", rows[0]), json_of("rays", rows[1])};
}

}  // namespace

int run_compare_shadows(const CompareCommand& command) {
    const ShadowTable& table = printed_tables().shadows;
    if (command.threads && *command.threads != "1")
        return report(
            {.reason = "--threads: " + table.name + " runs on one; leave the option out"});
    const auto settings =
        read_compared_settings(command, table.name + " is of shadows", "16", table.size_px);
    if (!settings) return report(settings.error());
    const CompareOutput output(command.json);
    if (const auto message = output.unwritable()) return report_run_time(*message);
    output.print(heading_text(table, settings->size_px));
    Json rows = Json::array();
    for (const PrintedScene& scene : table.scenes) {
        const auto request = compiled(item_of(scene), settings->settings, settings->size());
        if (!request) return report(request.error());
        for (Json& row : rows_of(scene, *request)) {
            output.print(row_line(shadow_columns(), row));
            rows.push_back(std::move(row));
        }
    }
    return output.finish({{"table", table.name},
                          {"source", table.source},
                          {"note", table.note},
                          {"printed_minutes",
                           {{"rays", table.printed_rays_min}, {"boxes", table.printed_boxes_min}}},
                          {"rows", rows}});
}

}  // namespace zeroset
