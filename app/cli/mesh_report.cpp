#include "app/cli/mesh_report.hpp"

#include "engine/base/text.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

std::string size_text(const Box& bounds, double mm_per_unit) {
    const glm::dvec3 size = mm_per_unit * (bounds.hi - bounds.lo);
    return short_number(size.x, 4) + " x " + short_number(size.y, 4) + " x " +
           short_number(size.z, 4) + " mm";
}

std::string topology_text(const MeshFacts& facts) {
    const std::string text = std::to_string(facts.components) +
                             (facts.components == 1 ? " component" : " components") +
                             ", Euler characteristic " + std::to_string(facts.euler());
    if (facts.open_edges == 0)
        return text + ", genus " + std::to_string(facts.genus()) + ", closed";
    return text + ", open (" + std::to_string(facts.open_edges) + " edges)";
}

std::string wall_text(const SurfaceMesh& surface, double mm) {
    if (!surface.wall) return "";
    const glm::dvec3& at = surface.wall->at;
    return ", smallest wall " + short_number(surface.wall->thickness * mm, 3) + " mm near " +
           short_number(at.x, 3) + "," + short_number(at.y, 3) + "," + short_number(at.z, 3);
}

Json wall_of(const std::optional<SmallestWall>& wall, double mm) {
    if (!wall) return {};
    return {{"thickness", wall->thickness},
            {"mm", wall->thickness * mm},
            {"at", {wall->at.x, wall->at.y, wall->at.z}},
            {"places", wall->places}};
}

std::string surface_text(const SurfaceMesh& surface, double mm) {
    const MeshFacts& facts = surface.facts;
    const MeshReport& report = surface.report;
    std::string text = std::to_string(surface.number) + "  " + surface.text + "\n";
    text += "   " + std::to_string(facts.triangles) + " triangles, " +
            std::to_string(facts.vertices) + " vertices";
    if (report.thinned_from > facts.triangles)
        text += " (thinned from " + std::to_string(report.thinned_from) + ")";
    text += "; " + topology_text(facts) + "\n";
    text += "   " + size_text(facts.bounds, mm) + ", area " +
            short_number(facts.area * mm * mm * 1e-2, 5) + " cm2";
    if (facts.open_edges == 0)
        text += ", volume " + short_number(facts.volume * mm * mm * mm * 1e-3, 5) + " cm3";
    text += wall_text(surface, mm);
    text += "\n   measured distance from the surface at most " + short_number(report.deviation, 3) +
            " (" + short_number(report.deviation * mm, 3) + " mm)\n";
    return text + "   " + proof_line(report) + "\n";
}

Json json_of(const std::vector<UnprovedPlace>& places) {
    Json list = Json::array();
    for (const UnprovedPlace& place : places) {
        list.push_back({{"at", {place.cell.x, place.cell.y, place.cell.z}},
                        {"reach", place.reach},
                        {"cells", place.cells}});
    }
    return list;
}

Json stats_of(const SurfaceMesh& surface, double mm) {
    const MeshFacts& facts = surface.facts;
    const MeshReport& report = surface.report;
    const Box& bounds = facts.bounds;
    return {
        {"surface", surface.number},
        {"text", surface.text},
        {"triangles", facts.triangles},
        {"triangles_before_thinning", report.thinned_from},
        {"vertices", facts.vertices},
        {"components", facts.components},
        {"euler", facts.euler()},
        {"genus", facts.open_edges == 0 ? Json(facts.genus()) : Json()},
        {"open_edges", facts.open_edges},
        {"area", facts.area},
        {"volume", facts.open_edges == 0 ? Json(facts.volume) : Json()},
        {"smallest_wall", wall_of(surface.wall, mm)},
        {"bounds", {bounds.lo.x, bounds.hi.x, bounds.lo.y, bounds.hi.y, bounds.lo.z, bounds.hi.z}},
        {"size_mm",
         {mm * (bounds.hi.x - bounds.lo.x), mm * (bounds.hi.y - bounds.lo.y),
          mm * (bounds.hi.z - bounds.lo.z)}},
        {"deviation", std::isfinite(report.deviation) ? Json(report.deviation) : Json()},
        {"cells", report.cells},
        {"smallest_cell", report.smallest_cell},
        {"proved_cells", report.proved},
        {"unproved_cells", report.unproved},
        {"unproved_places", json_of(report.places)},
        {"sharp_cells", report.rough},
        {"sharp_places", json_of(report.rough_places)},
        {"isotopic", report.isotopic},
        {"as_proved", report.unchanged},
        {"dense", report.dense},
        {"cut", report.cut}};
}

}  // namespace

std::string mesh_text(const std::string& output, const DocumentMeshes& meshes) {
    const double mm = meshes.file.mm_per_unit;
    std::string text = output + ": tolerance " + short_number(meshes.tolerance, 4) + " (" +
                       short_number(meshes.tolerance * mm, 3) + " mm), a unit is " +
                       short_number(mm, 4) + " mm\n";
    for (const SurfaceMesh& surface : meshes.surfaces)
        text += surface_text(surface, mm);
    return text;
}

std::string mesh_warnings(const DocumentMeshes& meshes, double budget_s) {
    std::string text;
    for (const SurfaceMesh& surface : meshes.surfaces) {
        const MeshReport& report = surface.report;
        const std::string who = "zeroset: surface " + std::to_string(surface.number) + ": ";
        if (!report.isotopic) text += who + proof_line(report) + "\n";
        const std::string more = "--budget " + short_number(2.0 * budget_s);
        for (const std::string& line : limit_lines(report, more))
            text += who + line + "\n";
    }
    return text;
}

std::string mesh_stats(const DocumentMeshes& meshes, double elapsed_ms) {
    Json surfaces = Json::array();
    for (const SurfaceMesh& surface : meshes.surfaces)
        surfaces.push_back(stats_of(surface, meshes.file.mm_per_unit));
    const Json all{{"tolerance", meshes.tolerance},
                   {"mm_per_unit", meshes.file.mm_per_unit},
                   {"elapsed_ms", elapsed_ms},
                   {"surfaces", surfaces}};
    return all.dump(2);
}

}  // namespace zeroset
