#include "pipeline/fit_view.hpp"

#include "document/framing.hpp"
#include "engine/measure/extent.hpp"
#include "pipeline/picture_request.hpp"

#include <utility>

namespace zeroset {

std::string fit_view(Document& document, const PreparedDocument& prepared,
                     const TraceSettings& settings, glm::ivec2 size_px, bool fits_box,
                     const TimeLimit& limit) {
    const PictureRequest request =
        picture_request(prepared.formula, prepared.colors, document, settings, size_px);
    document.camera = request.camera;
    const double aspect = static_cast<double>(size_px.x) / size_px.y;
    Framing framing =
        frame_surfaces(document, find_extent(scene_of(request), limit), aspect, fits_box);
    document = std::move(framing.document);
    return framing.found ? "" : framing.note;
}

}  // namespace zeroset
