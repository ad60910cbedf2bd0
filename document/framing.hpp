#pragma once

#include "document/document.hpp"
#include "engine/measure/extent.hpp"

#include <string>

namespace zeroset {

/// A document that shows its surfaces, and in one line what was done or why nothing was.
struct Framing {
    Document document;
    std::string note;
    bool found = true;  ///< else the document is as it was
};

/// Looks at all of what the clip box shows, from the same direction and as near as can be. The clip
/// box becomes a cube about the surfaces, if it may (`may_clip`), where all of them is known and
/// sticks out of it or is smaller than a quarter of it; where it shows nothing of surfaces that go
/// on without known end, it grows until it does. `extent` is of the document's scene and clip box;
/// `aspect` the picture's width / height.
Framing frame_surfaces(const Document& document, const Extent& extent, double aspect,
                       bool may_clip = true);

}  // namespace zeroset
