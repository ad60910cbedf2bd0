#pragma once

#include "engine/view/camera.hpp"
#include "ui/model/clip_handles.hpp"
#include "ui/model/point_drag.hpp"
#include "ui/model/soft_wrap.hpp"

#include <glm/ext/vector_int2.hpp>

#include <optional>
#include <string>

namespace zeroset::ui {

/// A short smooth move of the document's camera, see ui/actions/view_moves.hpp.
struct ViewMove {
    Camera from, to;
    Camera last;  ///< what it made of the document's camera
    double elapsed_s = 0.0;
    bool begun = false;
};

/// The row whose field had the keyboard last, and the text that the field showed.
struct TypedField {
    int row = 0;
    WrappedText shown;
};

/// Where pointer and keyboard are and what they are in the middle of. Set by the panels; the owner
/// reads it.
struct Input {
    glm::ivec2 viewport_px{0};         ///< size of the area the picture fills, framebuffer pixels
    std::optional<ViewPoint> pointer;  ///< resting over the picture
    std::optional<HandleDrag> handle_drag;  ///< while a handle of the clip region is held
    std::optional<PointDrag> point_drag;    ///< while a point is held
    std::optional<ViewMove> move;           ///< while one is under way
    double pinch = 1.0;                     ///< two fingers moved apart by this factor, this frame
    unsigned gesture = 0;                   ///< grows with each press of a button
    bool held = false;                      ///< a button is down
    int typing_row = 0;                     ///< the row whose field has the keyboard; 0: none
    TypedField typed;
    std::string camera_error;  ///< what is wrong with the numbers of a camera that were typed last
};

}  // namespace zeroset::ui
