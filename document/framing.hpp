#pragma once

#include "document/document.hpp"
#include "engine/measure/extent.hpp"

#include <string>

namespace zeroset {

/// A document that shows its surfaces, and one line that says what was done or why nothing was.
struct Framing {
    Document document;
    std::string note;
    bool found = true;  ///< false: the document is unchanged
};

/// The extent in a world that is drawn stretched (Camera), in the formula's.
Extent unstretched(Extent extent, const glm::dvec3& stretch);

/// The document's camera for a world that is drawn with this stretch (Camera); one that shows the
/// whole box where it has none for it.
Camera camera_of(const Document& document, double aspect, const glm::dvec3& stretch);
Camera camera_of(const Document& document, double aspect = 1.0);

/// Shows all that is in the clip box, from the same direction and as near as possible. With
/// `may_clip`, the clip box becomes a cube about the surfaces where all of them is known and sticks
/// out of the box or is smaller than a quarter of it; where the box holds nothing of surfaces
/// without a known end, it grows until it does. `extent` is that of the document's scene and clip
/// box; `aspect` is the picture's width / height.
Framing frame_surfaces(const Document& document, const Extent& extent, double aspect,
                       bool may_clip = true);

}  // namespace zeroset
