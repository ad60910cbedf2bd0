#pragma once

#include "engine/draw/drawing.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace zeroset {

/// The treatment of the parts of curves that surfaces hide.
enum class HiddenLines : std::uint8_t { Remove, Dash, Show };
/// "remove", "dash", "show".
std::optional<HiddenLines> hidden_lines_named(std::string_view name);

/// How the lines of a drawing look in a file.
struct DrawingStyle {
    HiddenLines hidden = HiddenLines::Remove;
    double width_pt = 1.0;  ///< of silhouettes; the others are thinner
    /// Widths of lines of one kind, by CurveKind; none: a part of `width_pt`.
    std::array<std::optional<double>, 5> widths_pt = {};
    double tolerance_pt = 0.05;                    ///< places are written to a hundredth of it
    std::optional<std::uint32_t> background = {};  ///< 0xRRGGBB; none: the page's, or transparent
};

/// One list of paths that look alike, in the order in which they are to be drawn.
struct LineGroup {
    CurveKind kind;
    bool hidden;
    double width_pt;
    double dash_pt, gap_pt;  ///< 0: not dashed
};
/// The groups of a drawing in a style: hidden ones first, silhouettes last.
std::vector<LineGroup> line_groups(const LineDrawing& drawing, const DrawingStyle& style);

/// The digits after the point of places written in points, and of widths.
int decimals(const DrawingStyle& style);
inline constexpr int width_decimals = 6;

}  // namespace zeroset
