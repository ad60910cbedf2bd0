#include "papers/compare/compared_row.hpp"
#include "papers/compare/formatted.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

// The text of a comparison, as `zeroset compare` prints it.

namespace zeroset {
namespace {

std::string optional_text(const char* format, const std::optional<double>& value) {
    return value ? formatted(format, *value) : "-";
}

double percent(std::uint64_t part, double whole) {
    return 100.0 * static_cast<double>(part) / whole;
}

}  // namespace

std::string heading_text(const Comparison& comparison) {
    const PrintedTable& table = *comparison.table;
    return std::string(table.source) + " (" + std::string(table.machine) +
           "): " + std::string(table.note) + ".\n" +
           formatted(
               "Here %dx%d, %d thread(s), medians of %d; cells, values: boxes and beams, "
               "points a ray; missed, added, moved:\npixels unlike those proved by beams at "
               "d_stop %d; x: times the paper's first tracer, here and as printed.\n\n",
               comparison.width, comparison.height, comparison.threads, comparison.repeats,
               max_d_stop) +
           formatted("%-19s %6s %7s %-16s %10s %8s %8s %7s %7s %7s %9s %7s %11s %9s\n", "surface",
                     "d_stop", "mirrors", "tracer", "ms", "cells", "values", "missed", "added",
                     "moved", "undecided", "x", "printed ms", "printed x");
}

std::string row_text(const ComparedRow& row) {
    return formatted("%-19s %6d %7d %-16s %10.2f %8.2f %8.2f %7zu %7zu %7zu %9zu %7s %11s %9s",
                     row.surface.c_str(), row.d_stop, row.reflections, row.tracer.c_str(),
                     row.median_ms, row.cells_per_ray, row.values_per_ray, row.wrong.missed,
                     row.wrong.added, row.wrong.moved, row.counts.undecided,
                     optional_text("%.2f", row.times).c_str(),
                     optional_text("%.0f", row.printed_ms).c_str(),
                     optional_text("%.2f", row.printed_times).c_str()) +
           (row.counters.is_cut() ? "  (cut by --budget)\n" : "\n");
}

std::string means_text(const std::vector<ComparedRow>& rows) {
    std::string text;
    for (const ComparedMean& mean : means_of(rows))
        text += formatted("%-19s %6d %7d %-16s %10.2f\n", "geometric mean", mean.wanted_d_stop,
                          mean.reflections, mean.tracer.c_str(), mean.ms);
    return text;
}

std::string boxes_text(const Comparison& comparison, const std::vector<ComparedRow>& rows) {
    const std::vector<BoxSaving> savings = box_savings(rows);
    if (savings.empty()) return {};
    const double pixels = static_cast<double>(comparison.width) * comparison.height;
    std::string text =
        "\nBoxes of the image: their number and the pixels in them; ms to find them; us a pixel "
        "of single rays (mrfro) in\nrejected boxes and in others; with nine rays a pixel in "
        "undefined boxes and one in included ones, rays and ms,\nand % that nine everywhere take "
        "longer. Second lines: as printed.\n\n" +
        formatted("%-15s %-15s %8s %6s %8s %6s %9s %6s %8s %8s %8s %8s %8s %8s\n", "surface",
                  "tracer", "rejected", "%", "included", "%", "undefined", "%", "ms", "rejected",
                  "others", "rays", "ms", "%");
    for (const BoxSaving& saving : savings) {
        const ImageBoxCounters& boxes = saving.boxes->boxes;
        const auto kept = static_cast<double>(boxes.included.pixels + boxes.undefined.pixels);
        const auto rejected = static_cast<double>(boxes.rejected.pixels);
        text += formatted(
            "%-15s %-15s %8llu %6.1f %8llu %6.1f %9llu %6.1f %8.2f %8.3f %8.3f %8.0f %8.1f %8.0f\n",
            saving.boxes->surface.c_str(), saving.boxes->tracer.c_str(),
            static_cast<unsigned long long>(boxes.rejected.boxes),
            percent(boxes.rejected.pixels, pixels),
            static_cast<unsigned long long>(boxes.included.boxes),
            percent(boxes.included.pixels, pixels),
            static_cast<unsigned long long>(boxes.undefined.boxes),
            percent(boxes.undefined.pixels, pixels), boxes.ms,
            rejected > 0 ? 1000.0 * saving.rejected_ms / rejected : 0.0,
            kept > 0 ? 1000.0 * saving.kept_ms / kept : 0.0, saving.rays, saving.rays_ms,
            100.0 * (9.0 * saving.classic->median_ms / saving.rays_ms - 1.0));
        const PrintedBoxes* const printed = comparison.table->boxes_of(saving.boxes->surface);
        if (printed == nullptr) continue;
        const double all = printed->rejected_pixels + printed->kept_pixels;
        if (all > 0) {
            text += formatted("%-15s %-15s %8d %6.1f %8s %6s %9d %6.1f %8.0f %8.0f %8.0f\n", "",
                              "printed", printed->rejected, 100.0 * printed->rejected_pixels / all,
                              "-", "-", printed->kept, 100.0 * printed->kept_pixels / all,
                              1000.0 * printed->trimming_s,
                              1e6 * printed->rejected_s / printed->rejected_pixels,
                              1e6 * printed->kept_s / printed->kept_pixels);
        }
        if (printed->rays > 0) {
            const auto ms = [&](const ComparedRow& row) { return row.printed_ms.value_or(0.0); };
            text += formatted("%-15s %-15s %64s %9d %8.0f %8.0f\n", "", "printed", "",
                              printed->rays, ms(*saving.boxes),
                              100.0 * (ms(*saving.classic) / ms(*saving.boxes) - 1.0));
        }
    }
    return text;
}

}  // namespace zeroset
