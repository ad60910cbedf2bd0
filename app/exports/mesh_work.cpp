#include "app/exports/exports.hpp"
#include "engine/base/clock.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/export/file.hpp"
#include "pipeline/plans/export_formats.hpp"
#include "pipeline/prepare.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace zeroset {
namespace {

/// Seconds after which a mesh stays as coarse as it is.
constexpr double mesh_budget_s = 30.0;

const char* name_of(MeshStage stage) {
    switch (stage) {
        case MeshStage::Dividing: return tr("dividing cells");
        case MeshStage::Proving: return tr("proving the topology");
        case MeshStage::Contouring: return tr("making triangles");
        case MeshStage::Thinning: return tr("taking out triangles");
    }
    return "";
}

MeshSettings settings_of(const ui::MeshExport& wish, double box_edge, ExportNews& news) {
    MeshSettings settings{.tolerance = wish.tolerance_mm * box_edge / wish.size_mm,
                          .size_mm = wish.size_mm,
                          .most_triangles = static_cast<std::size_t>(wish.most_triangles),
                          .open = wish.shape == ui::MeshExport::Shape::Open,
                          .limit = {.cancel = &news.cancel,
                                    .until = until_after(TimeLimit::Clock::now(), mesh_budget_s)},
                          .on_stage = [&news](MeshStage stage) { news.enter(name_of(stage)); }};
    if (wish.shape == ui::MeshExport::Shape::Wall) settings.wall_mm = wish.wall_mm;
    return settings;
}

ExportOutcome not_saved(const std::string& reason) {
    return std::unexpected(filled(tr("the mesh was not saved: {0}"), {reason}));
}

/// Writes the bytes; says `saved` where that is done.
ExportOutcome write_bytes(std::span<const std::byte> bytes, const std::filesystem::path& path,
                          const ExportNews& news, std::string saved) {
    if (news.cancel) return std::unexpected(tr("it was cancelled"));
    if (const auto written = write_file(path, bytes); !written)
        return std::unexpected(written.error().message);
    return saved;
}

ExportOutcome write(const DocumentMeshes& meshes, const std::filesystem::path& path,
                    ExportNews& news) {
    const MeshFormat* const format = mesh_format_of(path);
    if (format == nullptr) return not_saved(other_name(ExportKind::Mesh, path));
    if (auto writable = check_writable(path); !writable)
        return std::unexpected(writable.error().message);
    news.enter(tr("writing"));
    const auto bytes = format->encode(meshes.file);
    if (!bytes) return not_saved(bytes.error());
    std::size_t triangles = 0;
    for (const SurfaceMesh& surface : meshes.surfaces)
        triangles += surface.facts.triangles;
    return write_bytes(
        *bytes, path, news,
        filled(tr("saved {0} ({1} triangles)"), {path.filename().string(), grouped(triangles)}));
}

ExportOutcome write_level_sets(const ExportSubject& subject, const ui::MeshExport& wish,
                               const std::filesystem::path& path, ExportNews& news) {
    const MeshFormat* const format = mesh_format_of(path);
    if (format == nullptr || format->ending != ui::formula_ending)
        return not_saved(filled(tr("the formula itself is written as 3MF alone: type a name that "
                                   "ends in {0}, or choose another shape"),
                                {ui::formula_ending}));
    if (auto writable = check_writable(path); !writable)
        return std::unexpected(writable.error().message);
    news.enter(tr("writing"));
    const auto encoded = make_level_sets(subject, wish);
    if (!encoded) return not_saved(encoded.error());
    return write_bytes(
        encoded->bytes, path, news,
        filled(tr("saved {0} ({1} nodes)"), {path.filename().string(), grouped(encoded->nodes)}));
}

/// The request that a file is made from, with code that takes no time to make.
std::expected<PictureRequest, std::string> request_of(const ExportSubject& subject) {
    const Document document = unstretched(subject.document);
    auto prepared = prepare(document, subject.rows(), Preparation::Interpreted);
    if (!prepared) return std::unexpected(prepared.error().reason);
    constexpr glm::ivec2 size_px(1024, 1024);  // for the camera that distances are taken from
    return picture_request(prepared->formula, prepared->colors, document, subject.settings,
                           size_px);
}

}  // namespace

std::expected<std::shared_ptr<const DocumentMeshes>, std::string> make_meshes(
    const ExportSubject& subject, const ui::MeshExport& wish, ExportNews& news) {
    news.enter(tr("making code"));
    const auto request = request_of(subject);
    if (!request) return std::unexpected(request.error());
    auto meshes = mesh_document(*request, settings_of(wish, request->clip.size(), news));
    if (news.cancel) return std::unexpected(tr("it was cancelled"));
    if (!meshes) return std::unexpected(meshes.error().reason);
    if (meshes->surfaces.empty()) return std::unexpected(nothing_found(*meshes));
    return std::make_shared<const DocumentMeshes>(std::move(*meshes));
}

std::expected<EncodedLevelSets, std::string> make_level_sets(const ExportSubject& subject,
                                                             const ui::MeshExport& wish) {
    const auto request = request_of(subject);
    if (!request) return std::unexpected(request.error());
    auto encoded = encoded_level_sets_of(*request, wish.size_mm);
    if (!encoded) return std::unexpected(encoded.error().reason);
    return std::move(*encoded);
}

ExportWork mesh_work(ExportSubject subject, const ui::MeshExport& wish, std::filesystem::path path,
                     std::shared_ptr<const DocumentMeshes> made, std::shared_ptr<MadeMeshes> kept) {
    return [subject = std::move(subject), wish, path = std::move(path), made = std::move(made),
            kept = std::move(kept)](ExportNews& news) -> ExportOutcome {
        if (wish.shape == ui::MeshExport::Shape::Formula)
            return write_level_sets(subject, wish, path, news);
        if (made != nullptr) return write(*made, path, news);
        const auto meshes = make_meshes(subject, wish, news);
        if (!meshes) return std::unexpected(meshes.error());
        if (kept != nullptr) kept->meshes = *meshes;
        return write(**meshes, path, news);
    };
}

}  // namespace zeroset
