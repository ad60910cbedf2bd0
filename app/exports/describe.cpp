#include "app/exports/previews.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace zeroset {
namespace {

std::string shown_number(double value, int digits) {
    return localized(short_number(value, digits));
}

constexpr const char* times = " × ";
constexpr double cm2_per_mm2 = 1e-2;
constexpr double cm3_per_mm3 = 1e-3;
/// Straight pieces that a curve of a preview is shown by.
constexpr int pieces_shown = 8;

/// `one` for one thing, else `many` with the number for its {0}; both in the user's language.
std::string counted(std::size_t count, const char* one, const char* many) {
    return count == 1 ? one : filled(many, {grouped(count)});
}

std::string size_text(const glm::dvec3& size) {
    return shown_number(size.x, 4) + times + shown_number(size.y, 4) + times +
           shown_number(size.z, 4) + " mm";
}

std::string shape_text(const MeshFacts& facts) {
    const std::string parts = counted(facts.components, tr("1 component"), tr("{0} components"));
    if (facts.open_edges > 0) return filled(tr("{0}, open"), {parts});
    return filled(tr("{0}, genus {1}, closed"), {parts, std::to_string(facts.genus())});
}

std::string measures(const MeshFacts& facts, double mm) {
    const std::string area = shown_number(facts.area * mm * mm * cm2_per_mm2, 4);
    if (facts.open_edges > 0) return filled(tr("area {0} cm²"), {area});
    const std::string volume = shown_number(facts.volume * mm * mm * mm * cm3_per_mm3, 4);
    return filled(tr("area {0} cm², volume {1} cm³"), {area, volume});
}

/// Says first what those who print ask: whether that goes, or why not, and how thin walls are.
void judge_printing(const DocumentMeshes& meshes, ui::ExportPreview& shown) {
    constexpr double least_wall_mm = 0.8;  // two lines of a usual nozzle
    const bool open = std::ranges::any_of(
        meshes.surfaces, [](const SurfaceMesh& surface) { return surface.facts.open_edges > 0; });
    std::optional<double> wall_mm;
    for (const SurfaceMesh& surface : meshes.surfaces) {
        if (!surface.wall || !surface.wall->but_for_rims) continue;
        const double thickness = *surface.wall->but_for_rims * meshes.file.mm_per_unit;
        wall_mm = std::min(wall_mm.value_or(thickness), thickness);
    }
    shown.is_good = !open && wall_mm.value_or(least_wall_mm) >= least_wall_mm;
    if (open) {
        shown.verdict =
            tr("Cannot be printed as it is: the surface is open. Choose the shape Wall "
               "or Solid.");
    } else if (!shown.is_good) {
        shown.verdict = filled(tr("Closed, but too thin for many printers: walls of {0} mm. A "
                                  "larger size helps."),
                               {shown_number(*wall_mm, 2)});
    } else {
        shown.verdict = tr("Can be printed: closed on all sides.");
    }
    if (wall_mm)
        shown.facts.push_back(
            filled(tr("thinnest wall {0} mm, but for rims"), {shown_number(*wall_mm, 3)}));
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
    judge_printing(meshes, shown);
    const double mm = meshes.file.mm_per_unit;
    for (const SurfaceMesh& surface : meshes.surfaces) {
        const MeshFacts& facts = surface.facts;
        const bool several = meshes.surfaces.size() > 1;
        const auto of_surface = [&](const std::string& line) {
            if (!several) return line;
            return filled(tr("Surface {0}: {1}"), {std::to_string(surface.number), line});
        };
        const std::string triangles =
            counted(facts.triangles, tr("1 triangle"), tr("{0} triangles"));
        shown.facts.push_back(
            of_surface(triangles + ", " + size_text(mm * (facts.bounds.hi - facts.bounds.lo))));
        shown.facts.push_back(measures(facts, mm));
        shown.details.push_back(of_surface(shape_text(facts)));
        if (surface.wall) {
            shown.details.push_back(filled(tr("at rims down to {0} mm thin, as measured"),
                                           {shown_number(surface.wall->thickness * mm, 3)}));
        }
        shown.details.push_back(filled(tr("at most {0} mm from the surface, as measured"),
                                       {shown_number(surface.report.deviation * mm, 2)}));
        (surface.report.isotopic ? shown.details : shown.warnings)
            .push_back(of_surface(proof_line(surface.report)));
        for (const std::string& line : limit_lines(surface.report, tr("more time")))
            shown.warnings.push_back(of_surface(line));
    }
}

void describe(const EncodedLevelSets& level_sets, const glm::dvec3& size_mm,
              ui::ExportPreview& shown) {
    const std::string surfaces = counted(level_sets.surfaces, tr("1 surface"), tr("{0} surfaces"));
    const std::string nodes = counted(level_sets.nodes, tr("1 node"), tr("{0} nodes"));
    shown.facts.push_back(
        filled(tr_in("surfaces of nodes", "{0} of {1}, without triangles"), {surfaces, nodes}));
    shown.facts.push_back(filled(tr("in a box of {0}"), {size_text(size_mm)}));
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
    const std::string curves = counted(drawing.paths.size(), tr("1 curve"), tr("{0} curves"));
    const std::string of = counted(pieces, tr("1 Bézier piece"), tr("{0} Bézier pieces"));
    shown.facts.push_back(filled(tr_in("curves of pieces", "{0} of {1}"), {curves, of}));
}

}  // namespace zeroset
