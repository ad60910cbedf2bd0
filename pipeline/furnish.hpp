#pragma once

#include "document/document.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/view/camera.hpp"

#include <expected>
#include <string>

namespace zeroset {

/// The picture with the document's axes, clip box and grid over its colours, or one line that says
/// why they cannot be drawn.
std::expected<Framebuffer, std::string> furnished(const Framebuffer& picture,
                                                  const Document& document, const Camera& camera);

}  // namespace zeroset
