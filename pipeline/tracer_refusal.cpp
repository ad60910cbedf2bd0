#include "pipeline/tracer_refusal.hpp"

#include "engine/base/translation.hpp"
#include "engine/render/tracers.hpp"
#include "engine/trace/ways/surface_ways.hpp"

namespace zeroset {

std::optional<std::string> tracer_refusal(std::string_view tracer, std::string_view name,
                                          const PictureRequest& request) {
    const Tracer* const found = find_tracer(tracer);
    if (found == nullptr || !request.formula) return std::nullopt;
    for (const std::size_t surface : shown_indices(request)) {
        const Kernel& kernel = request.formula->kernels[surface];
        if (!found->takes_ways && !way_of(kernel).is_level_set()) {
            return std::string(name) + ": " +
                   tr("draws equations alone; for parametric surfaces, curves and points choose "
                      "beams");
        }
        if (found->needs.refuses == nullptr) continue;
        if (const char* const reason = found->needs.refuses(kernel))
            return std::string(name) + ": " + tr(reason);
    }
    return std::nullopt;
}

}  // namespace zeroset
