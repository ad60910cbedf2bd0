#include "pipeline/fit_view.hpp"

#include "document/framing.hpp"
#include "engine/measure/extent.hpp"
#include "pipeline/picture_request.hpp"

#include <utility>

namespace zeroset {

std::string fit_view(Document& document, const PictureRequest& request, double aspect,
                     bool fits_box, const TimeLimit& limit) {
    document.camera = request.camera;
    Framing framing =
        frame_surfaces(document, find_extent(scene_of(request), limit), aspect, fits_box);
    document = std::move(framing.document);
    return framing.found ? "" : framing.note;
}

}  // namespace zeroset
