#include "app/cli/commands.hpp"
#include "app/cli/mesh_report.hpp"
#include "app/cli/options/option_reader.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/report.hpp"
#include "engine/base/clock.hpp"
#include "engine/base/text.hpp"
#include "engine/export/file.hpp"
#include "pipeline/level_set_document.hpp"
#include "pipeline/mesh_document.hpp"
#include "pipeline/plans/export_formats.hpp"
#include "pipeline/prepare.hpp"

#include <malloc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <string_view>
#include <utility>

namespace zeroset {
namespace {

using Clock = TimeLimit::Clock;

/// The meaning of the options, checked before any work.
struct MeshPlan {
    Document document;
    RowProgram rows;
    MeshSettings settings;
    const MeshFormat* format = nullptr;
    double budget_s = default_budget_s;
};

OrInputError<const MeshFormat*> read_format(const std::string& output) {
    if (const MeshFormat* const format = mesh_format_of(output)) return format;
    return wrong_input("-o " + output + ": " + other_name(ExportKind::Mesh, output));
}

/// Reads a number above 0; `usual` if it was not given.
template <class Number>
OrInputError<Number> read_length(const std::string& option, const std::optional<std::string>& text,
                                 const char* about, Number usual) {
    if (!text) return usual;
    const auto number = read_number(option, *text);
    if (number && !(*number > 0 && *number <= 1e9))
        return wrong_input(option + " " + *text + ": type " + about + ", above 0");
    return number;
}

OrInputError<int> read_count(const std::string& option, const std::optional<std::string>& text,
                             int lowest, int highest) {
    return text ? read_integer(option, *text, lowest, highest) : OrInputError<int>(0);
}

/// Reads the options that are numbers. `surfaces`: how many the text has, for --surface.
void take_numbers(const MeshCommand& command, std::size_t surfaces, OptionReader& reader,
                  MeshPlan& plan) {
    constexpr int deepest = 18;
    constexpr int most_triangles = 1'000'000'000;
    MeshSettings& settings = plan.settings;
    reader.take(settings.tolerance, read_length("--tolerance", command.tolerance,
                                                "a distance in world units", settings.tolerance));
    reader.take(settings.size_mm,
                read_length("--size", command.size, "a length in millimetres", settings.size_mm));
    reader.take(settings.wall_mm, read_length("--wall", command.wall, "a thickness in millimetres",
                                              settings.wall_mm));
    reader.take(plan.budget_s, read_budget(command.budget));
    reader.take(settings.depth, read_count("--depth", command.depth, 3, deepest));
    reader.take(settings.most_triangles,
                read_count("--triangles", command.triangles, 4, most_triangles));
    reader.take(settings.threads, read_count("--threads", command.threads, 1, 1024));
    std::size_t surface = 0;
    reader.take(surface, read_count("--surface", command.surface, 1, static_cast<int>(surfaces)));
    if (surface > 0) settings.surface = surface;
}

OrInputError<MeshPlan> plan_of(const MeshCommand& command) {
    MeshPlan plan;
    const auto format = read_format(command.output);
    if (!format) return std::unexpected(format.error());
    plan.format = *format;
    auto input = read_document_with_rows(command.equation, command.view);
    if (!input) return std::unexpected(input.error());
    plan.document = unstretched(std::move(input->document));
    plan.rows = std::move(*input->rows);
    plan.settings.open = command.open;
    plan.settings.thin = !command.no_thin;
    OptionReader reader;
    take_numbers(command, plan.rows.program->surfaces.size(), reader, plan);
    return reader.finish(std::move(plan));
}

Progress::Stage stage_of(MeshStage stage) {
    switch (stage) {
        case MeshStage::Dividing: return Progress::Stage::Dividing;
        case MeshStage::Proving: return Progress::Stage::Proving;
        case MeshStage::Contouring: return Progress::Stage::Contouring;
        case MeshStage::Thinning: return Progress::Stage::Thinning;
    }
    return Progress::Stage::Dividing;
}

/// Makes the meshes, with a line that tells how far the work is.
OrInputError<DocumentMeshes> make_meshes(MeshPlan plan) {
    Progress progress;
    OrInputError<DocumentMeshes> meshes;
    const auto start = Clock::now();
    finish_until(TimeLimit::never, progress, [&] {
        auto prepared = prepare(plan.document, plan.rows, Preparation::Interpreted);
        if (!prepared) {
            meshes = std::unexpected(prepared.error());
            return;
        }
        constexpr glm::ivec2 size_px(1024, 1024);  // for the camera that distances are taken from
        const PictureRequest request =
            picture_request(prepared->formula, prepared->colors, plan.document, {}, size_px);
        plan.settings.limit.until = until_after(start, plan.budget_s);
        plan.settings.on_stage = [&](MeshStage stage) { progress.enter(stage_of(stage)); };
        meshes = mesh_document(request, plan.settings);
    });
    return meshes;
}

std::expected<void, std::string> write_mesh(const std::string& output, const MeshFormat& format,
                                            const MeshFile& file) {
    const auto bytes = format.encode(file);
    if (!bytes) return std::unexpected("cannot write '" + output + "': " + bytes.error());
    const auto written = write_file(output, *bytes);
    if (!written) return std::unexpected(written.error().message);
    return {};
}

/// Returns an error for an option about triangles, which --implicit does not write.
std::optional<InputError> implicit_refusal(const MeshCommand& command, const MeshPlan& plan) {
    if (plan.format->ending != ".3mf")
        return InputError{.reason = "--implicit writes 3MF alone: type -o NAME.3mf"};
    const std::array<std::pair<std::string_view, bool>, 8> others{
        {{"--tolerance", command.tolerance.has_value()},
         {"--triangles", command.triangles.has_value()},
         {"--wall", command.wall.has_value()},
         {"--depth", command.depth.has_value()},
         {"--budget", command.budget.has_value()},
         {"--stats", command.stats.has_value()},
         {"--open", command.open},
         {"--no-thin", command.no_thin}}};
    for (const auto& [option, given] : others) {
        if (given)
            return InputError{.reason = std::string(option) +
                                        " is about triangles, which --implicit does not make: "
                                        "leave one of them out"};
    }
    return std::nullopt;
}

int write_implicit(const MeshCommand& command, const MeshPlan& plan) {
    if (auto wrong = implicit_refusal(command, plan)) return report(*wrong);
    auto prepared = prepare(plan.document, plan.rows, Preparation::Interpreted);
    if (!prepared) return report(prepared.error());
    constexpr glm::ivec2 size_px(64, 64);  // for a camera that is not used
    const PictureRequest request =
        picture_request(prepared->formula, prepared->colors, plan.document, {}, size_px);
    const auto encoded =
        encoded_level_sets_of(request, plan.settings.size_mm, plan.settings.surface);
    if (!encoded) return report(encoded.error());
    if (const auto written = write_file(command.output, encoded->bytes); !written)
        return report_run_time(written.error().message);
    const std::size_t count = encoded->surfaces;
    std::cout << "wrote " << command.output << ": " << count
              << (count == 1 ? " surface of " : " surfaces of ") << encoded->nodes
              << " nodes, in a box of " << short_number(plan.settings.size_mm) << " mm\n";
    return exit_ok;
}

/// Large arrays come and go. Memory that the system takes back it gives again only page by page,
/// each of them cleared, which takes an eighth of the time.
void keep_memory() {
    constexpr int mebibyte = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, 32 * mebibyte);
    mallopt(M_TRIM_THRESHOLD, 1024 * mebibyte);
    mallopt(M_TOP_PAD, 16 * mebibyte);
}

}  // namespace

int run_mesh(const MeshCommand& command) {
    const auto start = Clock::now();
    keep_memory();
    auto plan = plan_of(command);
    if (!plan) return report(plan.error());
    if (const auto message = first_unwritable({command.output, command.stats}))
        return report_run_time(*message);
    if (command.implicit) return write_implicit(command, *plan);
    const MeshFormat& format = *plan->format;
    const double budget_s = plan->budget_s;
    const auto meshes = make_meshes(std::move(*plan));
    if (!meshes) return report(meshes.error());
    if (meshes->surfaces.empty()) return report_run_time(nothing_found(*meshes));
    const auto written = write_mesh(command.output, format, meshes->file);
    if (!written) return report_run_time(written.error());
    if (command.stats != "-") std::cout << mesh_text(command.output, *meshes);
    std::cerr << mesh_warnings(*meshes, budget_s);
    if (command.stats) {
        const auto stats = write_text(*command.stats, mesh_stats(*meshes, ms_since(start)) + "\n");
        if (!stats) return report_run_time(stats.error().message);
    }
    const bool inexact = std::ranges::any_of(
        meshes->surfaces, [](const SurfaceMesh& mesh) { return misses_tolerance(mesh.report); });
    return inexact ? exit_inexact : exit_ok;
}

}  // namespace zeroset
