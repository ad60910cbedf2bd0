#pragma once

#include "document/document.hpp"
#include "engine/draw/drawing.hpp"
#include "engine/draw/page.hpp"
#include "engine/trace/time_limit.hpp"
#include "pipeline/picture_request.hpp"

namespace zeroset {

/// The document's axes, clip box, grid and markers on a page, which are those of a picture of the
/// same view. `request`: for a picture of the document in the page's shape.
DrawnMarks drawing_marks(const Document& document, const PictureRequest& request,
                         const PageSize& page, const TimeLimit& limit);

}  // namespace zeroset
