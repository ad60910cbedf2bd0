#pragma once

#include "document/document.hpp"
#include "engine/measure/extent.hpp"

#include <optional>
#include <string>

namespace zeroset {

/// Whether something of the clip box is drawn: axes with numbers, its edges, or the grid.
bool draws_box(const Document& document);

/// The box that is looked at to see the whole clip box: larger where numbers stand beside it.
Box box_in_view(const Document& document);

/// `camera` moved to look at the whole clip box in its direction, in a picture of this aspect
/// (width / height), and at the numbers beside it where there are axes.
Camera whole_view(const Camera& camera, const Document& document, double aspect);

/// The camera that a picture of this aspect is taken with. The field of view is that of the smaller
/// side: a picture narrower than high is not cropped at the sides.
Camera fitting(const Camera& camera, double aspect);

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

/// Shows all that is in the clip box, and the box itself where it is drawn, from the same direction
/// and as near as possible. With `may_clip`, the clip box becomes a cube about the surfaces where
/// all of them is known and sticks out of the box or is smaller than a quarter of it; where the box
/// holds nothing of surfaces without a known end, it grows until it does. `extent` is that of the
/// document's scene and clip box; `aspect` is the picture's width / height.
Framing frame_surfaces(const Document& document, const Extent& extent, double aspect,
                       bool may_clip = true);

/// Does frame_surfaces where the whole surface is known and leaves the usual clip box; where it
/// does not, the usual clip box. Nothing where that is the document's already, or where the surface
/// goes on too far to tell.
std::optional<Framing> frame_by_itself(const Document& document, const Extent& extent,
                                       double aspect);

}  // namespace zeroset
