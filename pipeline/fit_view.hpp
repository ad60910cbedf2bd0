#pragma once

#include "document/document.hpp"
#include "engine/language/parse.hpp"
#include "engine/trace/time_limit.hpp"
#include "engine/view/box.hpp"
#include "pipeline/picture_request.hpp"

#include <optional>
#include <string>

namespace zeroset {

/// The clip box that plotting commands in a program's text ask for: their ranges, and where a graph
/// z = f(x, y) has none for z the heights that it reaches over them, without a few far ones and at
/// most twice its width. Axes that nothing is known of are those of the usual box. Nothing where no
/// command gives a range.
std::optional<Box> asked_box(const Program& program);

/// Makes the document's camera look at all of its surfaces, in a picture of this aspect (width /
/// height); `fits_box`: and fits the clip box to them. `request`: for a picture of the document.
/// Returns one line on why it cannot, or that surfaces go on beyond what is shown; else nothing.
std::string fit_view(Document& document, const PictureRequest& request, double aspect,
                     bool fits_box, const TimeLimit& limit);

}  // namespace zeroset
