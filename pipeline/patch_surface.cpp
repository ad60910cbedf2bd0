#include "pipeline/patch_surface.hpp"

#include "engine/kernel/patch_code.hpp"
#include "jit/compile.hpp"
#include "pipeline/patch_shapes.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace zeroset {
namespace {

constexpr double thickness = 0.006;  // of the clip box's longest edge

}  // namespace

Expr drawn_formula(const Expr& surface, const Box& clip) {
    const auto graphs = patch_of(surface);
    const bool is_meeting = graphs && graphs->kind == PatchKind::Meeting;
    return is_meeting ? meeting_tube(*graphs, thickness * clip.size()) : surface;
}

Kernel patch_code(const PatchGraphs& graphs, const Box& clip) {
    const std::array<Expr, 3> shown = shown_patch(graphs, thickness * clip.size());
    std::array<Kernel, 3> point;
    std::ranges::transform(shown, point.begin(), [](const Expr& graph) {
        Kernel kernel = jit::compile_when_called(graph);
        kernel.has_double = true;
        return kernel;
    });
    return patch_kernel(std::move(point));
}

std::optional<InputError> patch_refusal(const PictureRequest& request, std::string reason) {
    const bool any = std::ranges::any_of(request.surfaces, [&](const ShownSurface& surface) {
        return is_patch(request.formula->program->surfaces[surface.index]);
    });
    if (!any) return std::nullopt;
    return InputError{.reason = std::move(reason)};
}

}  // namespace zeroset
