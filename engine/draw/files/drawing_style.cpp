#include "engine/draw/files/drawing_style.hpp"

#include "engine/draw/files/encoders.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// Widths of lines in widths of silhouettes, unless others are asked for.
double usual_share(CurveKind kind) {
    switch (kind) {
        case CurveKind::Silhouette: return 1.0;
        case CurveKind::Crease:
        case CurveKind::Boundary:
        case CurveKind::Intersection: return 0.8;
        case CurveKind::Contour: return 0.4;
    }
    return 1.0;
}

double width_of(CurveKind kind, const LineDrawing& drawing, const DrawingStyle& style) {
    if (const auto width = style.widths_pt.at(static_cast<std::size_t>(kind))) return *width;
    if (kind == CurveKind::Contour && drawing.contour_width_pt) return *drawing.contour_width_pt;
    return usual_share(kind) * style.width_pt;
}

}  // namespace

std::optional<HiddenLines> hidden_lines_named(std::string_view name) {
    if (name == "remove") return HiddenLines::Remove;
    if (name == "dash") return HiddenLines::Dash;
    if (name == "show") return HiddenLines::Show;
    return std::nullopt;
}

std::vector<LineGroup> line_groups(const LineDrawing& drawing, const DrawingStyle& style) {
    constexpr double hidden_width = 0.6;
    constexpr double dash = 3.0;
    constexpr double gap = 2.5;
    std::vector<LineGroup> groups;
    for (const bool hidden : {true, false}) {
        if (hidden && style.hidden == HiddenLines::Remove) continue;
        const double share = hidden ? hidden_width : 1.0;
        const double dashes = hidden && style.hidden == HiddenLines::Dash ? style.width_pt : 0.0;
        for (const CurveKind kind :
             {CurveKind::Contour, CurveKind::Intersection, CurveKind::Boundary, CurveKind::Crease,
              CurveKind::Silhouette}) {
            groups.push_back({.kind = kind,
                              .hidden = hidden,
                              .width_pt = share * width_of(kind, drawing, style),
                              .dash_pt = dash * dashes,
                              .gap_pt = gap * dashes});
        }
    }
    return groups;
}

std::optional<double> shown_width(const DrawnLine& line, const DrawingStyle& style) {
    constexpr double of_hidden = 0.4;
    if (!line.hidden) return line.width_pt;
    if (style.hidden == HiddenLines::Remove) return std::nullopt;
    return of_hidden * line.width_pt;
}

int decimals(const DrawingStyle& style) {
    return std::clamp(static_cast<int>(std::ceil(-std::log10(style.tolerance_pt))) + 2, 2, 8);
}

}  // namespace zeroset
