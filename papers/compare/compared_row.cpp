#include "papers/compare/compared_row.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace zeroset {

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

std::vector<ComparedMean> means_of(const std::vector<ComparedRow>& rows) {
    std::map<std::tuple<int, int, std::string>, std::pair<double, int>> sums;
    for (const ComparedRow& row : rows) {
        auto& [sum, count] = sums[{row.wanted_d_stop, row.reflections, row.tracer}];
        sum += std::log(row.median_ms);
        ++count;
    }
    std::vector<ComparedMean> means;
    means.reserve(sums.size());
    for (const auto& [key, sum] : sums)
        means.push_back({.wanted_d_stop = std::get<0>(key),
                         .reflections = std::get<1>(key),
                         .tracer = std::get<2>(key),
                         .ms = std::exp(sum.first / sum.second)});
    return means;
}

std::vector<BoxSaving> box_savings(const std::vector<ComparedRow>& rows) {
    constexpr double rays_at_edges = 9.0;
    std::vector<BoxSaving> savings;
    for (const ComparedRow& row : rows) {
        if (!row.has_boxes()) continue;
        const auto classic = std::ranges::find_if(rows, [&](const ComparedRow& other) {
            return other.same_case(row) && other.tracer == "mrfro";
        });
        if (classic == rows.end()) continue;
        const ImageBoxCounters& boxes = row.boxes;
        const double kept_ms = boxes.included.ms + boxes.undefined.ms;
        savings.push_back(
            {.boxes = &row,
             .classic = &*classic,
             .rejected_ms = std::max(classic->median_ms - kept_ms, 0.0),
             .kept_ms = kept_ms,
             .rays = static_cast<double>(boxes.included.pixels) +
                     rays_at_edges * static_cast<double>(boxes.undefined.pixels),
             .rays_ms = boxes.ms + boxes.included.ms + rays_at_edges * boxes.undefined.ms});
    }
    return savings;
}

}  // namespace zeroset
