#pragma once

#include "engine/annotate/shapes.hpp"
#include "papers/compare/compared_row.hpp"

#include <glm/ext/vector_double2.hpp>

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// The times of a comparison as a picture: a line for each row, grouped by surface, over a
/// logarithmic axis of times; a dot for this machine, a ring for what is printed.
struct ComparisonPlot {
    Shapes shapes;
    glm::dvec2 size;  ///< of the canvas
};
ComparisonPlot comparison_plot(const Comparison& comparison, const std::vector<ComparedRow>& rows,
                               const TextWidth& width);

enum class PlotFormat : std::uint8_t { Svg, Png };
/// By the ending of a file's name; nothing for any other.
std::optional<PlotFormat> plot_format(const std::string& path);

/// Writes the plot; the error is one line.
std::expected<void, std::string> write_plot(const std::string& path, PlotFormat format,
                                            const Comparison& comparison,
                                            const std::vector<ComparedRow>& rows);

}  // namespace zeroset
