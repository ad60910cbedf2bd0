#pragma once

#include "document/document.hpp"
#include "engine/trace/time_limit.hpp"
#include "pipeline/picture_request.hpp"

#include <string>

namespace zeroset {

/// Makes the document's camera look at all of its surfaces, in a picture of this aspect (width /
/// height); `fits_box`: and fits the clip box to them. `request`: for a picture of the document.
/// Returns one line on why it cannot, or nothing.
std::string fit_view(Document& document, const PictureRequest& request, double aspect,
                     bool fits_box, const TimeLimit& limit);

}  // namespace zeroset
