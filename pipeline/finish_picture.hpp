#pragma once

#include "document/document.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/scene/coloring.hpp"
#include "engine/view/camera.hpp"

#include <expected>
#include <memory>
#include <string>

namespace zeroset {

/// The things that axes, markers and legend are made from, beside the frame itself.
struct FrameSubject {
    const Document& document;
    const Camera& camera;      ///< the camera that the frame was drawn with
    const Coloring& coloring;  ///< the frame's colouring, with the range of its values
    bool legend = true;        ///< draw a legend, if the colours stand for something
};

/// Draws the document's axes, clip box, grid and markers and the legend of the colours over the
/// frame. Returns the frame itself if there is none of them, or one line that says why they cannot
/// be drawn.
std::expected<std::shared_ptr<const Framebuffer>, std::string> finish_picture(
    std::shared_ptr<const Framebuffer> frame, const FrameSubject& subject);

}  // namespace zeroset
