#include "papers/compare/compared_row.hpp"

#include "papers/compare/text_columns.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json json_of(const ImageBoxCounters::Kind& kind) {
    return {{"boxes", kind.boxes}, {"pixels", kind.pixels}, {"ms", kind.ms}};
}

const std::array<TextColumn, 14>& frame_columns() {
    static const std::array<TextColumn, 14> all{{{"surface", "/surface", -19},
                                                 {"d_stop", "/d_stop", 6},
                                                 {"mirrors", "/reflections", 7},
                                                 {"tracer", "/tracer", -16},
                                                 {"ms", "/frame_ms/median", 10, 2},
                                                 {"cells", "/cells_per_ray", 8, 2},
                                                 {"values", "/values_per_ray", 8, 2},
                                                 {"missed", "/missed", 7},
                                                 {"added", "/added", 7},
                                                 {"moved", "/moved", 7},
                                                 {"undecided", "/undecided", 9},
                                                 {"x", "/times", 7, 2},
                                                 {"printed ms", "/printed_ms", 11},
                                                 {"printed x", "/printed_times", 9, 2}}};
    return all;
}

}  // namespace

void set_times(std::vector<ComparedRow>& rows) {
    for (ComparedRow& row : rows) {
        const auto base = std::ranges::find_if(
            rows, [&](const ComparedRow& other) { return other.same_case(row) && other.of_table; });
        if (base == rows.end()) continue;
        row.times = row.median_ms / base->median_ms;
        if (row.printed_ms && base->printed_ms)
            row.printed_times = *row.printed_ms / *base->printed_ms;
    }
}

std::string heading_text(const Comparison& comparison) {
    const PrintedTable& table = *comparison.table;
    return table.source + " (" + table.machine + "): " + table.note + ".\n" +
           formatted(
               "Here %dx%d, %d thread(s), medians of %d; cells, values: boxes and beams, "
               "points a ray; missed, added, moved:\npixels unlike those proved by beams at "
               "d_stop %d; x: times the paper's first tracer, here and as printed.\n\n",
               comparison.width, comparison.height, comparison.threads, comparison.repeats,
               max_d_stop) +
           title_line(frame_columns());
}

std::string row_text(const ComparedRow& row) {
    std::string line = row_line(frame_columns(), json_of(row));
    if (row.counters.is_cut()) line.insert(line.size() - 1, "  (cut by --budget)");
    return line;
}

Json json_of(const ComparedRow& row) {
    Json json{{"surface", row.surface},
              {"d_stop", row.d_stop},
              {"wanted_d_stop", row.wanted_d_stop},
              {"reflections", row.reflections},
              {"tracer", row.tracer},
              {"frame_ms",
               {{"median", row.median_ms},
                {"min", row.min_ms},
                {"max", row.max_ms},
                {"repeats", row.repeats}}},
              {"prepared_ms", row.prepared_ms},
              {"cut", row.counters.is_cut()},
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
              {"times", or_null(row.times)},
              {"printed_ms", or_null(row.printed_ms)},
              {"printed_times", or_null(row.printed_times)}};
    if (row.has_boxes()) {
        const ImageBoxCounters& boxes = row.boxes;
        json["boxes"] = {{"rejected", json_of(boxes.rejected)},
                         {"included", json_of(boxes.included)},
                         {"undefined", json_of(boxes.undefined)},
                         {"ms", boxes.ms}};
    }
    return json;
}

Json json_of(const Comparison& comparison, const std::vector<ComparedRow>& rows) {
    Json json_rows = Json::array();
    for (const ComparedRow& row : rows)
        json_rows.push_back(json_of(row));
    const PrintedTable& table = *comparison.table;
    return {{"table", table.name},
            {"source", table.source},
            {"machine_printed", table.machine},
            {"note", table.note},
            {"width", comparison.width},
            {"height", comparison.height},
            {"threads", comparison.threads},
            {"rows", json_rows}};
}

}  // namespace zeroset
