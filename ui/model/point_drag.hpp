#pragma once

#include "document/document.hpp"
#include "document/shown_point.hpp"
#include "engine/view/camera.hpp"

#include <map>
#include <optional>
#include <span>
#include <string>

namespace zeroset::ui {

/// Sliders by name, w among them.
using Sliders = std::map<std::string, Slider>;

/// The sliders that move a point.
Sliders sliders_of(const ShownPoint& point, const Document& document);
/// Gives a document these sliders.
void take_over(Document& document, const Sliders& sliders);

/// The nearest point that can be moved within `reach` of the cursor, in heights of the picture.
const ShownPoint* point_under(std::span<const ShownPoint> points, const ViewFrame& view,
                              const ViewPoint& cursor, double reach);

/// A point that is held.
struct PointDrag {
    ShownPoint point;       ///< as it was grabbed
    Sliders start;          ///< as they were then
    Sliders last;           ///< what the drag made of them
    ViewShift off;          ///< from the cursor to the point
    bool given_up = false;  ///< does nothing more until it is let go
};

PointDrag grabbed(const ShownPoint& point, const Document& document, const ViewFrame& view,
                  const ViewPoint& cursor);

/// The sliders that take the point below the cursor, in the plane through where it was that is
/// parallel to the picture, as far as sliders are its coordinates: to numbers no finer than pixels
/// of a picture of `height_px`, or to the slider's steps. A slider that is several coordinates
/// takes their mean.
Sliders dragged(const PointDrag& drag, const ViewFrame& view, const ViewPoint& cursor,
                int height_px);

}  // namespace zeroset::ui
