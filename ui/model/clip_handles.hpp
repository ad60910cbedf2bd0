#pragma once

#include "engine/scene/region.hpp"
#include "engine/view/camera.hpp"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// Handles in the picture that move what surfaces are clipped to. Places in the picture are those of
// PointerMotion::cursor: in heights of it, from its centre, to the right and upwards.

namespace zeroset::ui {

enum class HandlePart : std::uint8_t { BoxFace, BallCentre, BallRadius, SectionPlace, SectionTilt };

struct HandleId {
    HandlePart part = HandlePart::BoxFace;
    std::size_t index = 0;  ///< of a face: twice its axis, and 1 more at the upper end; a section's

    bool operator==(const HandleId&) const = default;
};

/// A point in space to grab and, of a section's, the stem that leads there.
struct Handle {
    HandleId id;
    glm::dvec3 from{0.0};  ///< where the stem begins, on the plane; `at` where there is none
    glm::dvec3 at{0.0};
    glm::dvec3 along{0.0};  ///< outward, length 1: the line that it moves on; 0: it moves freely

    bool operator==(const Handle&) const = default;
};

/// Box and region that surfaces are clipped to.
struct Clipping {
    Box clip;
    Region region;

    bool operator==(const Clipping&) const = default;
};

/// The handles that can be moved in this view: one whose line is seen end-on is left out. `stem`:
/// the length of a section's arrow in heights of the picture.
std::vector<Handle> clip_handles(const Clipping& clipping, const ViewFrame& view, double stem);

/// The nearest handle (or stem) within `reach` of the cursor.
std::optional<Handle> handle_under(std::span<const Handle> handles, const ViewFrame& view,
                                   const ViewPoint& cursor, double reach);

/// A handle that is held.
struct HandleDrag {
    Handle handle;          ///< as it was grabbed
    Clipping start;         ///< as it was then
    Clipping last;          ///< what the drag made of it
    ViewShift off;          ///< from the cursor to the handle
    bool given_up = false;  ///< does nothing more until it is let go
};

/// Keys that are held down with the pointer's button.
struct DragKeys {
    bool shift = false;  ///< the opposite face moves, too; a normal goes to even directions
    bool ctrl = false;   ///< all faces of the box move alike
};

HandleDrag grabbed(const Handle& handle, const Clipping& clipping, const ViewFrame& view,
                   const ViewPoint& cursor);

/// Box and region that the drag makes of `drag.start` with the cursor here: numbers no finer than
/// pixels of a picture of `height_px`. As it was last where the cursor is beyond the horizon. The
/// box keeps a thousandth of its size between faces.
Clipping dragged(const HandleDrag& drag, const ViewFrame& view, const ViewPoint& cursor,
                 int height_px, const DragKeys& keys);

/// The handles of `clipping` while one of them is held: a section turns about where it was grabbed.
void hold(std::vector<Handle>& handles, const HandleDrag& drag, const Clipping& clipping);

}  // namespace zeroset::ui
