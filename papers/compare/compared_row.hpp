#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/measure/wrong_pixels.hpp"
#include "engine/scene/settings.hpp"
#include "papers/compare/printed_tables.hpp"
#include "papers/florez/box_tally.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// The facts that all rows of a comparison share.
struct Comparison {
    const PrintedTable* table;
    int width, height, threads, repeats;
};

/// A row: a surface by a tracer at a tolerance, measured here and as printed.
struct ComparedRow {
    std::string surface, tracer;
    int wanted_d_stop = 0;  ///< of the table
    int d_stop = 0;         ///< of the tracer: no more than it has
    int reflections = 0;
    int repeats = 0;  ///< frames that were timed
    double median_ms = 0.0, min_ms = 0.0, max_ms = 0.0;
    Counters counters;            ///< of one frame
    ImageBoxCounters boxes;       ///< of one frame, where the tracer makes boxes of the image
    double cells_per_ray = 0.0;   ///< boxes and cells that were evaluated
    double values_per_ray = 0.0;  ///< points
    double prepared_ms = 0.0;     ///< what was made once of the surface, before the frames
    CertificateCounts counts{};
    WrongPixels wrong;
    std::size_t certified_there = 0;  ///< pixels that are certified in the finest picture by beams
    bool of_table = false;            ///< whether the table names it, with a figure or without
    std::optional<double> printed_ms;
    /// Times over those of the surface's first tracer of the table, at this tolerance and with as
    /// many reflections.
    std::optional<double> times, printed_times;

    [[nodiscard]] bool same_case(const ComparedRow& other) const {
        return surface == other.surface && wanted_d_stop == other.wanted_d_stop &&
               reflections == other.reflections;
    }
    /// Whether the tracer made boxes of the image.
    [[nodiscard]] bool has_boxes() const {
        return boxes.rejected.boxes + boxes.included.boxes + boxes.undefined.boxes > 0;
    }
};

/// Fills in the times over those of the first tracer with a printed value.
void set_times(std::vector<ComparedRow>& rows);

/// The text of a comparison: heading, a line for each row.
std::string heading_text(const Comparison& comparison);
std::string row_text(const ComparedRow& row);

/// A row as JSON.
nlohmann::ordered_json json_of(const ComparedRow& row);
/// All of it as JSON.
nlohmann::ordered_json json_of(const Comparison& comparison, const std::vector<ComparedRow>& rows);

}  // namespace zeroset
