#pragma once

#include "document/document.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/scene/coloring.hpp"
#include "engine/view/camera.hpp"

#include <expected>
#include <memory>
#include <string>

namespace zeroset {

/// The subject of a frame, of which axes, markers and legend tell.
struct FrameSubject {
    const Document& document;
    const Camera& camera;      ///< that the frame was drawn with
    const Coloring& coloring;  ///< of the frame, with the range that its colours have
    bool legend = true;        ///< where the colours tell something
};

/// The finished picture: the frame with the document's axes, clip box, grid and markers and its
/// legend over its colours; the frame itself where there is none of them. Or one line that says why
/// they cannot be drawn.
std::expected<std::shared_ptr<const Framebuffer>, std::string> finish_picture(
    std::shared_ptr<const Framebuffer> frame, const FrameSubject& subject);

}  // namespace zeroset
