#include "app/exports/describe.hpp"

#include "engine/base/text.hpp"

#include <cmath>
#include <cstddef>
#include <string>

namespace zeroset {
namespace {

constexpr const char* times = " \xC3\x97 ";
constexpr double cm2_per_mm2 = 1e-2;
constexpr double cm3_per_mm3 = 1e-3;
/// Straight pieces that a curve of a preview is shown by.
constexpr int pieces_shown = 8;

std::string counted(std::size_t count, const char* what) {
    return grouped(count) + " " + what + (count == 1 ? "" : "s");
}

std::string size_text(const Box& bounds, double mm) {
    const glm::dvec3 size = mm * (bounds.hi - bounds.lo);
    return short_number(size.x, 4) + times + short_number(size.y, 4) + times +
           short_number(size.z, 4) + " mm";
}

std::string shape_text(const MeshFacts& facts) {
    const std::string text = counted(facts.components, "component");
    if (facts.open_edges > 0) return text + ", open";
    return text + ", genus " + std::to_string(facts.genus()) + ", closed";
}

std::string measures(const MeshFacts& facts, double mm) {
    std::string text =
        "area " + short_number(facts.area * mm * mm * cm2_per_mm2, 4) + " cm\xC2\xB2";
    if (facts.open_edges == 0)
        text += ", volume " + short_number(facts.volume * mm * mm * mm * cm3_per_mm3, 4) +
                " cm\xC2\xB3";
    return text;
}

/// The curve's points, as parts of the page.
std::vector<glm::dvec2> points_of(const DrawnPath& path, const PageSize& page) {
    std::vector<glm::dvec2> points;
    for (const Bezier& piece : path.pieces) {
        for (int i = points.empty() ? 0 : 1; i <= pieces_shown; ++i) {
            const double t = static_cast<double>(i) / pieces_shown;
            const double s = 1.0 - t;
            const glm::dvec2 at = s * s * s * piece[0] + 3.0 * s * s * t * piece[1] +
                                  3.0 * s * t * t * piece[2] + t * t * t * piece[3];
            points.emplace_back(at.x / page.width, at.y / page.height);
        }
    }
    return points;
}

}  // namespace

void describe(const DocumentMeshes& meshes, ui::ExportPreview& shown) {
    const double mm = meshes.file.mm_per_unit;
    for (const SurfaceMesh& surface : meshes.surfaces) {
        const MeshFacts& facts = surface.facts;
        const std::string who =
            meshes.surfaces.size() > 1 ? "Surface " + std::to_string(surface.number) + ": " : "";
        shown.facts.push_back(who + counted(facts.triangles, "triangle") + ", " +
                              shape_text(facts));
        shown.facts.push_back(size_text(facts.bounds, mm) + ", " + measures(facts, mm));
        if (surface.wall) {
            shown.facts.push_back("smallest wall " + short_number(surface.wall->thickness * mm, 3) +
                                  " mm, as measured");
        }
        shown.facts.push_back("at most " + short_number(surface.report.deviation * mm, 2) +
                              " mm from the surface, as measured");
        (surface.report.isotopic ? shown.facts : shown.warnings)
            .push_back(who + proof_line(surface.report));
        for (const std::string& line : limit_lines(surface.report, "more time"))
            shown.warnings.push_back(who + line);
    }
}

void describe(const LineDrawing& drawing, const DrawingStyle& style, ui::ExportPreview& shown) {
    for (const LineGroup& group : line_groups(drawing, style)) {
        for (const DrawnPath& path : drawing.paths) {
            if (path.kind != group.kind || path.hidden != group.hidden) continue;
            shown.lines.push_back({.points = points_of(path, drawing.size),
                                   .width_pt = static_cast<float>(group.width_pt),
                                   .dashed = group.dash_pt > 0.0});
        }
    }
    std::size_t pieces = 0;
    for (const DrawnPath& path : drawing.paths)
        pieces += path.pieces.size();
    const std::string lacks = drawing.lacks(style.tolerance_pt);
    if (!lacks.empty()) shown.warnings.push_back(lacks);
    shown.facts.push_back(counted(drawing.paths.size(), "curve") + " of " +
                          counted(pieces, "B\xC3\xA9zier piece"));
}

}  // namespace zeroset
