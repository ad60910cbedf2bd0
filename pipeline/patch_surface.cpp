#include "pipeline/patch_surface.hpp"

#include "engine/kernel/patch_code.hpp"
#include "engine/rewrite/differences/removable_poles.hpp"
#include "engine/taylor/patch_models.hpp"
#include "jit/compile.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr double usual_radius = 0.006;  // of the clip box's longest edge

/// The items of the uniforms that graphs read.
std::vector<std::size_t> uniforms_read(const std::array<Expr, 3>& graphs) {
    std::set<std::size_t> items;
    for (const Expr& graph : graphs) {
        for (const Node& node : graph.nodes()) {
            if (node.op == Op::Variable && node.number >= variable_w)
                items.insert(static_cast<std::size_t>(node.number - variable_w));
        }
    }
    return {items.begin(), items.end()};
}

}  // namespace

Expr drawn_formula(const Expr& surface, std::size_t thickness) {
    const auto graphs = patch_of(surface);
    const bool is_meeting = graphs && graphs->kind == PatchKind::Meeting;
    return is_meeting ? meeting_tube(*graphs, thickness) : surface;
}

Kernel patch_code(const PatchGraphs& graphs, std::size_t thickness) {
    std::array<Expr, 3> shown = shown_patch(graphs, thickness);
    for (Expr& coordinate : shown) {
        if (auto continuous = without_removable_poles(coordinate))
            coordinate = std::move(*continuous);
    }
    std::array<Kernel, 3> point;
    std::ranges::transform(shown, point.begin(), [](const Expr& graph) {
        Kernel kernel = jit::compile_when_called(graph);
        kernel.has_double = true;
        return kernel;
    });
    return patch_kernel(std::move(point), graphs.box, patch_modeler(shown), uniforms_read(shown));
}

ThicknessUniforms thickness_of(PatchKind kind, const std::optional<Thickness>& chosen,
                               const Box& clip, const Camera& camera, int height_px) {
    if (!chosen) return {(kind == PatchKind::Point ? 2.0 : 1.0) * usual_radius * clip.size()};
    const double radius = 0.5 * chosen->width;
    if (!chosen->in_pixels) return {radius};
    const ViewFrame view(camera);
    if (view.parallel()) return {radius * view.pixel_at_look(height_px)};
    // A pixel is as wide as the depth along the view axis says.
    const glm::dvec3 slope = radius * view.pixel_size(height_px) * view.forward;
    return {-glm::dot(slope, view.eye), slope.x, slope.y, slope.z};
}

std::optional<InputError> patch_refusal(const PictureRequest& request, std::string reason) {
    const bool any = std::ranges::any_of(request.surfaces, [&](const ShownSurface& surface) {
        return is_patch(request.formula->program->surfaces[surface.index]);
    });
    if (!any) return std::nullopt;
    return InputError{.reason = std::move(reason)};
}

}  // namespace zeroset
