#include "pipeline/mesh_document.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/mesh/finished_mesh.hpp"
#include "engine/real/rounding.hpp"
#include "pipeline/mesh_solid.hpp"
#include "pipeline/patch_surface.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {
namespace {

std::string place_text(const UnprovedPlace& place) {
    return short_number(place.cell.x, 4) + "," + short_number(place.cell.y, 4) + "," +
           short_number(place.cell.z, 4);
}

/// The sentence, and in which places that is so.
std::string with_places(const std::string& sentence, const std::vector<UnprovedPlace>& places) {
    if (places.empty()) return sentence;
    constexpr std::size_t most_places = 4;
    std::string list;
    for (std::size_t i = 0; i < std::min(most_places, places.size()); ++i)
        list += (i > 0 ? "; " : "") + place_text(places[i]);
    if (places.size() > most_places) list += "; ...";
    if (places.size() == 1) return filled(tr("{0}, in 1 place: near {1}"), {sentence, list});
    return filled(tr("{0}, in {1} places: near {2}"),
                  {sentence, std::to_string(places.size()), list});
}

/// The document's meshes, one after the other.
class DocumentMesher {
public:
    DocumentMesher(const PictureRequest& request, const MeshSettings& settings)
        : request_(request), settings_(settings), scene_(scene_of(request)) {
        result_.tolerance = settings.tolerance.value_or(1e-3 * request.clip.size());
    }
    void add(std::size_t index, SurfaceSolid surface, std::size_t left);
    OrInputError<DocumentMeshes> finish();

private:
    std::optional<InputError> make_walls(double size);
    void make_numbers_different();
    void measure(const TriangleMesh& mesh, SurfaceMesh& surface) const;
    [[nodiscard]] MeshOptions options(std::size_t left) const {
        return {.tolerance = result_.tolerance,
                .depth = settings_.depth,
                .most_triangles = settings_.most_triangles,
                .thin = settings_.thin,
                .threads = settings_.threads,
                // Something is left for the measures and the file.
                .limit = settings_.limit.share(1, static_cast<int>(left)).share(7, 8),
                .on_stage = settings_.on_stage};
    }

    const PictureRequest& request_;
    const MeshSettings& settings_;
    Scene scene_;
    DocumentMeshes result_;
};

void DocumentMesher::add(std::size_t index, SurfaceSolid surface, std::size_t left) {
    MadeMesh made = make_mesh(surface.solid, options(left));
    const bool is_sheet = request_.formula->program->sheets[surface.number - 1];
    if (settings_.open || settings_.wall_mm || is_sheet) {
        const UpwardRegisters upward;
        keep_surface(made.mesh, surface.solid);
    }
    if (made.mesh.triangles.empty()) {
        result_.unproved += made.report.unproved + made.report.rough + made.report.proved;
        return;
    }
    result_.surfaces.push_back({.number = surface.number,
                                .text = surface.text,
                                .report = std::move(made.report),
                                .facts = {}});
    measure(made.mesh, result_.surfaces.back());
    MeshObject object{.name = std::move(surface.text), .mesh = std::move(made.mesh)};
    color_object(scene_, index, request_.camera.eye, object);
    result_.file.objects.push_back(std::move(object));
}

void DocumentMesher::measure(const TriangleMesh& mesh, SurfaceMesh& surface) const {
    surface.facts = facts_of(mesh);
    surface.wall.reset();
    if (surface.facts.open_edges > 0) return;
    const MeshWork work{.threads = settings_.threads, .limit = settings_.limit};
    surface.wall = smallest_wall(mesh, work);
}

OrInputError<DocumentMeshes> DocumentMesher::finish() {
    if (result_.surfaces.empty()) return std::move(result_);
    Box all = result_.surfaces.front().facts.bounds;
    for (const SurfaceMesh& surface : result_.surfaces) {
        all.lo = glm::min(all.lo, surface.facts.bounds.lo);
        all.hi = glm::max(all.hi, surface.facts.bounds.hi);
        result_.file.comment.push_back(std::to_string(surface.number) + ": " + surface.text + "; " +
                                       proof_line(surface.report));
    }
    if (all.size() > 0) result_.file.mm_per_unit = settings_.size_mm / all.size();
    if (settings_.wall_mm) {
        if (auto wrong = make_walls(all.size())) return std::unexpected(*wrong);
    }
    make_numbers_different();
    return std::move(result_);
}

/// Makes the meshes those that readers of any file get.
void DocumentMesher::make_numbers_different() {
    std::vector<double> scales;
    scales.reserve(std::size(mesh_file_units));
    for (const double unit : mesh_file_units)
        scales.push_back(unit * result_.file.mm_per_unit);
    for (std::size_t i = 0; i < result_.surfaces.size(); ++i) {
        MeshObject& object = result_.file.objects[i];
        const std::size_t before = object.mesh.vertices.size();
        const auto left = zeroset::make_numbers_different(object.mesh, scales);
        result_.surfaces[i].facts = facts_of(object.mesh);  // of moved points, too
        if (left.size() == before) continue;
        result_.surfaces[i].report.unchanged = false;
        if (object.colors.empty()) continue;
        std::vector<MeshColor> colors;
        colors.reserve(left.size());
        for (const std::uint32_t v : left)
            colors.push_back(object.colors[v]);
        object.colors = std::move(colors);
    }
}

/// Makes the surfaces walls, whose longest edge, with the wall, is of the size asked for.
std::optional<InputError> DocumentMesher::make_walls(double size) {
    const double wall_mm = *settings_.wall_mm;
    if (!(wall_mm < settings_.size_mm))
        return InputError{.reason =
                              filled(tr("{0}: it must be thinner than {1}"), {"--wall", "--size"})};
    result_.file.mm_per_unit = (settings_.size_mm - wall_mm) / size;
    const double thickness = wall_mm / result_.file.mm_per_unit;
    for (std::size_t i = 0; i < result_.surfaces.size(); ++i) {
        MeshObject& object = result_.file.objects[i];
        auto wall = wall_of(object.mesh, thickness, result_.tolerance);
        if (!wall) {
            return InputError{
                .reason = filled(tr("{0}: surface {1}: {2}; a thinner one may do"),
                                 {"--wall " + short_number(wall_mm),
                                  std::to_string(result_.surfaces[i].number), wall.error()})};
        }
        object.mesh = std::move(*wall);
        const std::vector<MeshColor> colors = object.colors;
        object.colors.insert(object.colors.end(), colors.begin(), colors.end());
        measure(object.mesh, result_.surfaces[i]);
        result_.surfaces[i].report.unchanged = false;
    }
    return std::nullopt;
}

}  // namespace

std::string proof_line(const MeshReport& report) {
    if (report.isotopic) {
        return report.unchanged
                   ? tr("mesh proved isotopic to the surface")
                   : tr("topology proved; edges put in or triangles taken out since keep "
                        "components and genus");
    }
    const std::size_t all = report.proved + report.rough + report.unproved;
    if (report.unproved == 0) {
        return with_places(
            filled(tr("topology proved but for {0} of {1} cells, at edges too sharp for it"),
                   {std::to_string(report.rough), std::to_string(all)}),
            report.rough_places);
    }
    return with_places(
        filled(tr("topology not proved in {0} of {1} cells"),
               {std::to_string(report.unproved + report.rough), std::to_string(all)}),
        report.places);
}

bool misses_tolerance(const MeshReport& report) {
    constexpr double measuring = 1.01;
    constexpr double unknown = 1e20;
    return report.deviation > measuring * report.tolerance && report.deviation < unknown;
}

std::vector<std::string> limit_lines(const MeshReport& report, const std::string& more_time) {
    std::vector<std::string> lines;
    if (report.dense) {
        lines.push_back(filled(tr("f is not enclosed closely enough along its surface: cells there "
                                  "are left unproved at a size of some {0}"),
                               {short_number(report.smallest_cell, 2)}));
    }
    if (misses_tolerance(report)) {
        lines.push_back(filled(
            tr("triangles are up to {0} away from the surface, more than the tolerance of {1}"),
            {short_number(report.deviation, 3), short_number(report.tolerance, 3)}));
    }
    if (report.cut)
        lines.push_back(filled(
            tr("the time or the room for cells is spent; {0} or a larger tolerance gives more"),
            {more_time}));
    return lines;
}

std::string nothing_found(const DocumentMeshes& meshes) {
    if (meshes.unproved == 0)
        return tr("it is proved that no surface lies in the clip box; --box makes it larger");
    return filled(tr("f changes its sign nowhere between cells, but in {0} of them it may be 0: a "
                     "smaller --tolerance looks closer; f^2 = 0 has no inside"),
                  {std::to_string(meshes.unproved)});
}

OrInputError<DocumentMeshes> mesh_document(const PictureRequest& request,
                                           const MeshSettings& settings) {
    auto refused = patch_refusal(
        request, tr("a mesh is made of equations, not yet of parametric surfaces, curves and "
                    "points: hide their rows"));
    if (refused) return std::unexpected(std::move(*refused));
    auto solids = surface_solids(request);
    if (!solids) return std::unexpected(solids.error());
    DocumentMesher mesher(request, settings);
    const std::size_t wanted = settings.surface.value_or(0);
    for (std::size_t i = 0; i < solids->size(); ++i) {
        if (settings.limit.cancelled()) break;
        if (wanted != 0 && (*solids)[i].number != wanted) continue;
        mesher.add(i, std::move((*solids)[i]), wanted != 0 ? 1 : solids->size() - i);
    }
    return mesher.finish();
}

}  // namespace zeroset
