#include "papers/compare/compared_row.hpp"

#include <nlohmann/json.hpp>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json json_of(const ImageBoxCounters::Kind& kind) {
    return {{"boxes", kind.boxes}, {"pixels", kind.pixels}, {"ms", kind.ms}};
}

Json json_of(const ComparedRow& row, int repeats) {
    Json json{{"surface", row.surface},
              {"d_stop", row.d_stop},
              {"wanted_d_stop", row.wanted_d_stop},
              {"reflections", row.reflections},
              {"tracer", row.tracer},
              {"frame_ms",
               {{"median", row.median_ms},
                {"min", row.min_ms},
                {"max", row.max_ms},
                {"repeats", repeats}}},
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
              {"times", json_of(row.times)},
              {"printed_ms", json_of(row.printed_ms)},
              {"printed_times", json_of(row.printed_times)}};
    if (row.has_boxes()) {
        const ImageBoxCounters& boxes = row.boxes;
        json["boxes"] = {{"rejected", json_of(boxes.rejected)},
                         {"included", json_of(boxes.included)},
                         {"undefined", json_of(boxes.undefined)},
                         {"ms", boxes.ms}};
    }
    return json;
}

Json json_of(const BoxSaving& saving) {
    return {{"surface", saving.boxes->surface},
            {"tracer", saving.boxes->tracer},
            {"rejected_ms", saving.rejected_ms},
            {"kept_ms", saving.kept_ms},
            {"nine_rays", saving.rays},
            {"nine_rays_ms", saving.rays_ms},
            {"nine_rays_everywhere_ms", 9.0 * saving.classic->median_ms}};
}

}  // namespace

std::string comparison_json(const Comparison& comparison, const std::vector<ComparedRow>& rows) {
    Json json_rows = Json::array();
    for (const ComparedRow& row : rows)
        json_rows.push_back(json_of(row, comparison.repeats));
    Json means = Json::array();
    for (const ComparedMean& mean : means_of(rows))
        means.push_back({{"d_stop", mean.wanted_d_stop},
                         {"reflections", mean.reflections},
                         {"tracer", mean.tracer},
                         {"ms", mean.ms}});
    Json savings = Json::array();
    for (const BoxSaving& saving : box_savings(rows))
        savings.push_back(json_of(saving));
    const Json json{{"table", comparison.table->name},
                    {"source", comparison.table->source},
                    {"machine_printed", comparison.table->machine},
                    {"note", comparison.table->note},
                    {"width", comparison.width},
                    {"height", comparison.height},
                    {"threads", comparison.threads},
                    {"geometric_means", means},
                    {"rows", json_rows},
                    {"boxes", savings}};
    return json.dump(2) + "\n";
}

}  // namespace zeroset
