#include "pipeline/patch_surface.hpp"

#include "engine/base/translation.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/kernel/patch_code.hpp"
#include "jit/compile.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace zeroset {
namespace {

template <class Make>
Kernel patch_of(const PatchGraphs& graphs, const Make& make) {
    std::array<Kernel, 3> point;
    std::ranges::transform(graphs, point.begin(), [&](const Expr& graph) {
        Kernel kernel = make(graph);
        kernel.has_double = true;
        return kernel;
    });
    return patch_kernel(std::move(point));
}

}  // namespace

bool is_patch(const Program& program, std::size_t surface) {
    return surface < program.patches.size() && program.patches[surface].has_value();
}

Kernel patch_code(const PatchGraphs& graphs) {
    return patch_of(graphs, [](const Expr& graph) { return jit::compile_when_called(graph); });
}

Kernel interpreted_patch(const PatchGraphs& graphs) {
    return patch_of(graphs, [](const Expr& graph) { return interpret(graph); });
}

std::optional<InputError> patch_refusal(const PictureRequest& request, const std::string& what) {
    const bool any = std::ranges::any_of(request.surfaces, [&](const ShownSurface& surface) {
        return is_patch(*request.formula->program, surface.index);
    });
    if (!any) return std::nullopt;
    return InputError{
        .reason =
            filled(tr("{0} knows only equations: hide the rows of parametric surfaces, curves "
                      "and points, or type an equation in x, y and z"),
                   {what})};
}

}  // namespace zeroset
