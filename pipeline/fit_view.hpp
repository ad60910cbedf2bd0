#pragma once

#include "document/document.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/time_limit.hpp"
#include "pipeline/prepare.hpp"

#include <glm/ext/vector_int2.hpp>

#include <string>

namespace zeroset {

/// Makes the document's camera look at all of its surfaces, in a picture of this size; `fits_box`:
/// and fits the clip box to them. Returns one line on why it cannot, or nothing.
std::string fit_view(Document& document, const PreparedDocument& prepared,
                     const TraceSettings& settings, glm::ivec2 size_px, bool fits_box,
                     const TimeLimit& limit);

}  // namespace zeroset
