#include "app/cli/report.hpp"
#include "engine/base/clock.hpp"
#include "engine/trace/trace_frame.hpp"
#include "papers/commands/paper_commands.hpp"
#include "papers/octree/octree_memory.hpp"
#include "papers/octree/verification.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstddef>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

struct TraversalPlan {
    ReadDocument input;
    Size size{};
    TraceSettings settings;
};

OrInputError<TraversalPlan> plan_of(const TraversalCommand& command) {
    TraversalPlan plan;
    const auto size = read_size("--size", command.size);
    if (!size) return std::unexpected(size.error());
    plan.size = *size;
    TraceText text;
    text.tracer = name_of(Traversal::Octree);
    text.levels = command.levels.value_or("30");
    text.threads = command.threads;
    const auto settings = read_trace_settings(text);
    if (!settings) return std::unexpected(settings.error());
    plan.settings = *settings;
    auto input = read_document_with_rows(command.equation, command.view);
    if (!input) return std::unexpected(input.error());
    plan.input = std::move(*input);
    return plan;
}

/// The surfaces of a scene with their octrees.
struct VoxelisedScene {
    const Scene& scene;
    const PictureRequest& request;
    ViewFrame view;
    std::vector<std::shared_ptr<const Octree>> octrees;
    double voxelisation_ms = 0.0;

    VoxelisedScene(const Scene& of_scene, const PictureRequest& of_request)
        : scene(of_scene), request(of_request), view(of_request.camera) {
        const auto start = std::chrono::steady_clock::now();
        for (const Surface& surface : scene.surfaces) {
            octrees.push_back(std::static_pointer_cast<const Octree>(
                prepare_octree(frame_of(surface), request.settings.threads)));
        }
        voxelisation_ms = ms_since(start);
    }

    [[nodiscard]] TraceFrame frame_of(const Surface& surface) const {
        return trace_frame(scene, surface, view,
                           {.width = request.size_px.x, .height = request.size_px.y},
                           request.settings.stop);
    }
    [[nodiscard]] TraversalCheck check(Traversal traversal) const {
        TraversalCheck total;
        for (std::size_t i = 0; i < octrees.size(); ++i) {
            TraceFrame frame = frame_of(scene.surfaces[i]);
            frame.prepared = octrees[i].get();
            total += verify_traversal(frame, traversal, request.settings.threads);
        }
        return total;
    }
};

}  // namespace

int run_traversal(const TraversalCommand& command) {
    auto plan = plan_of(command);
    if (!plan) return report(plan.error());
    const Document& document = plan->input.document;
    const auto prepared = prepare(document, *plan->input.rows, Preparation::Compiled);
    if (!prepared) return report(prepared.error());
    PictureRequest request = picture_request(prepared->formula, prepared->colors, document,
                                             plan->settings, {plan->size.width, plan->size.height});
    add_needed_code(request);
    const Scene scene = scene_of(request);
    const VoxelisedScene voxelised(scene, request);
    std::size_t voxels = 0;
    std::size_t bytes = 0;
    for (const auto& octree : voxelised.octrees) {
        voxels += octree->voxels();
        bytes += octree->bytes();
    }
    Json checks = Json::array();
    for (const Traversal traversal :
         {Traversal::Octree, Traversal::Unrounded, Traversal::Gargantini}) {
        const TraversalCheck found = voxelised.check(traversal);
        checks.push_back({{"traversal", name_of(traversal)},
                          {"rays", found.rays},
                          {"octants", found.octants},
                          {"differing", found.differing},
                          {"missed", found.missed},
                          {"extra", found.extra}});
    }
    const Json answer{{"levels", static_cast<int>(plan->settings.stop.value)},
                      {"voxels", voxels},
                      {"octree_bytes", bytes},
                      {"voxelisation_ms", voxelised.voxelisation_ms},
                      {"traversals", checks}};
    std::cout << answer.dump(2) << '\n';
    return exit_ok;
}

}  // namespace zeroset
