#include "pipeline/tracer_refusal.hpp"

#include "engine/base/translation.hpp"
#include "engine/render/tracers.hpp"

namespace zeroset {

std::optional<std::string> tracer_refusal(std::string_view tracer, std::string_view name,
                                          const PictureRequest& request) {
    const Tracer* const found = find_tracer(tracer);
    if (found == nullptr || found->refuses == nullptr || !request.formula) return std::nullopt;
    for (const std::size_t surface : shown_indices(request)) {
        if (const char* const reason = found->refuses(request.formula->kernels[surface]))
            return std::string(name) + ": " + tr(reason);
    }
    return std::nullopt;
}

}  // namespace zeroset
